package tompkins.ui.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.render.Progress;
import tompkins.ui.Components;
import tompkins.ui.NeedsDisplay;
import tompkins.ui.WindowDriver;
import tompkins.ui.widget.Look;

/** What becomes of work in the background when it ends, is cancelled, or fails. */
@NeedsDisplay
class BackgroundTaskTest {

    private final List<String> ended = new ArrayList<>();
    private final CountDownLatch late = new CountDownLatch(1);
    private JFrame owner;

    @BeforeEach
    void open() {
        owner = WindowDriver.onEventThread(() -> {
            Look.LIGHT.install();
            JFrame frame = new JFrame();
            frame.setVisible(true);
            return frame;
        });
    }

    @AfterEach
    void close() {
        WindowDriver.onEventThread(() -> owner.dispose());
    }

    /** Work of which nothing comes. */
    private interface Errand {

        void run(Progress task) throws Exception;
    }

    private void begin(String title, Path file, Errand errand) {
        BackgroundTask.Work<String> work = task -> {
            errand.run(task);
            return "done";
        };
        BackgroundTask.start(owner, title, file, work, ended::add, () -> ended.add("not done"));
    }

    private void start(Errand errand) {
        WindowDriver.onEventThread(() -> begin("work", null, errand));
    }

    private Stream<JButton> cancel() {
        return Components.showing(owner, JButton.class).filter(button -> "Cancel".equals(button.getText()));
    }

    private void cancelWhileItRuns() {
        WindowDriver.await("the window of the task", () -> cancel().findAny().isPresent());
        WindowDriver.onEventThread(() -> cancel().forEach(JButton::doClick));
        late.countDown();
        awaitEnd();
    }

    private void awaitEnd() {
        WindowDriver.await("the end", () -> BackgroundTask.running(owner).isEmpty());
    }

    @Test
    void whatWasDoneBeforeCancelCameIsDone() {
        start(task -> assertThat(late.await(5, TimeUnit.MINUTES)).isTrue());
        cancelWhileItRuns();
        assertThat(ended).containsExactly("done");
    }

    @Test
    void whatIsCancelledInTimeIsNotDone() {
        start(task -> {
            assertThat(late.await(5, TimeUnit.MINUTES)).isTrue();
            task.requireWanted();
        });
        cancelWhileItRuns();
        assertThat(ended).containsExactly("not done");
    }

    @Test
    void whatIsNoLongerWantedIsNotFound() {
        find();
        cancelWhileItRuns();
        assertThat(ended).isEmpty();
    }

    private void find() {
        WindowDriver.onEventThread(() -> {
            BackgroundTask.find(
                    owner,
                    "work",
                    () -> {
                        assertThat(late.await(5, TimeUnit.MINUTES)).isTrue();
                        return "found";
                    },
                    ended::add);
        });
    }

    /** Enter would press Cancel there. */
    @Test
    void theKeysStayWhereTheyAre() {
        WindowDriver.await("the keys", owner::isFocused);
        AtomicBoolean took = new AtomicBoolean();
        WindowDriver.onEventThread(() -> owner.addWindowFocusListener(new WindowAdapter() {
            @Override
            public void windowLostFocus(WindowEvent event) {
                took.set(true);
            }
        }));
        find();
        WindowDriver.await("the window of the task", () -> cancel().findAny().isPresent());
        WindowDriver.await("its end", () -> {
            late.countDown();
            return !ended.isEmpty();
        });
        assertThat(took).isFalse();
    }

    /** A second writer might be faster than the first. */
    @Test
    void itIsKnownWhatIsWritten() {
        Path file = Path.of("scene.json");
        WindowDriver.onEventThread(() -> {
            begin("first", file, task -> late.await());
            assertThat(BackgroundTask.isWriting(Path.of("other.json"))).isFalse();
            assertThat(BackgroundTask.isWriting(Path.of("./scene.json"))).isTrue();
        });
        late.countDown();
        awaitEnd();
        assertThat(WindowDriver.onEventThread(() -> BackgroundTask.isWriting(file)))
                .isFalse();
    }

    @Test
    void aWindowCancelsAllItsWork() {
        WindowDriver.onEventThread(() -> {
            assertThat(BackgroundTask.cancel(owner)).as("nothing runs").isFalse();
            Errand work = task -> {
                while (!task.isCancelled()) {
                    assertThat(late.await(1, TimeUnit.MILLISECONDS)).isFalse();
                }
                task.requireWanted();
            };
            begin("first", null, work);
            assertThat(BackgroundTask.cancel(owner)).isTrue();
            BackgroundTask.whenIdle(owner, () -> ended.add("idle"));
        });
        awaitEnd();
        assertThat(ended).containsExactly("not done", "idle");
    }

    @Test
    void anyErrorIsToldAndEndsTheTask() {
        start(task -> {
            throw new LinkageError("a class is missing");
        });
        WindowDriver.await("the message", () -> Components.messages(owner).anyMatch("a class is missing"::equals));
        assertThat(WindowDriver.onEventThread(() -> BackgroundTask.running(owner)))
                .isEmpty();
        assertThat(ended).isEmpty();
    }
}
