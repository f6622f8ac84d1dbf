package tompkins.ui.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;

class StudioModelTest {

    private final StudioModel model = new StudioModel(speed(0), null);

    private static Studio speed(double beta) {
        return Studio.DEFAULT.withVelocity(Velocity.of(0, 0, beta));
    }

    /** Whoever only looked around is not asked about changes. */
    @Test
    void lookingIsNoEdit() {
        StudioModel model = new StudioModel(speed(0), null);
        Object hand = new Object();
        model.look(speed(0.1), hand);
        model.flow(speed(0.2), hand, Pace.RIDE);
        model.endGesture(hand);
        assertThat(model.isModified()).isTrue();
        assertThat(model.isEdited()).isFalse();
        model.set(speed(0.3));
        model.look(speed(0.4), hand);
        assertThat(model.isEdited()).isTrue();
        model.undo();
        model.undo();
        assertThat(model.isEdited()).as("as before the edit").isFalse();
        model.redo();
        assertThat(model.isEdited()).isTrue();
        model.saved(model.studio(), Path.of("a.json"));
        model.look(speed(0.5), hand);
        assertThat(model.isEdited()).as("after saving").isFalse();
    }

    @Test
    void everyStepCanBeTakenBackAndAgain() {
        model.set(speed(0.1));
        model.set(speed(0.2));
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0.1));
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0));
        assertThat(model.canUndo()).isFalse();
        model.undo();
        model.redo();
        model.redo();
        assertThat(model.studio()).isEqualTo(speed(0.2));
        assertThat(model.canRedo()).isFalse();
        model.undo();
        model.set(speed(0.3));
        assertThat(model.canRedo()).as("a new step forgets what was taken back").isFalse();
    }

    /** Gestures a and b change the speed, or end; a number alone is a change of its own, u takes a step back. */
    @ParameterizedTest
    @CsvSource({
        "a drag is one step, a0.1 a0.2 a0.3 u, 0",
        "from the same value it is a step of its own, 0.1 a0.1 a0.2 a0.2 a0.3 u, 0.1",
        "two drags are two steps, a0.1 a a0.2 u, 0.1",
        "two gestures at a time are two steps, a0.1 b0.2 a0.3 b0.4 a0.5 u, 0.1",
        "that of one is left of two at a time, a0.1 b0.2 a0.3 b0.4 a0.5 u u, 0",
        "the end of one gesture is not that of another, a0.1 b0.2 b a0.3 u, 0.1",
        "a change of its own ends all gestures, a0.1 0.2 a0.3 u, 0.2"
    })
    void gesturesAreSteps(String name, String steps, double speed) {
        for (String step : steps.split(" ")) {
            String gesture = step.substring(0, 1);
            if (step.equals("u")) {
                model.undo();
            } else if (step.length() == 1) {
                model.endGesture(gesture);
            } else if (Character.isDigit(step.charAt(0))) {
                model.set(speed(Double.parseDouble(step)));
            } else {
                model.adjust(speed(Double.parseDouble(step.substring(1))), gesture);
            }
        }
        assertThat(model.studio()).as(name).isEqualTo(speed(speed));
    }

    @Test
    void theLiveListenersAreToldThePace() {
        List<Pace> paces = new ArrayList<>();
        model.addLiveListener(paces::add);
        Object gesture = new Object();
        model.set(speed(0.1));
        model.flow(speed(0.2), gesture, Pace.ANSWER);
        model.flow(speed(0.3), gesture, Pace.RIDE);
        model.adjust(speed(0.4), gesture, Pace.FILM);
        model.undo();
        assertThat(paces).containsExactly(Pace.HAND, Pace.ANSWER, Pace.RIDE, Pace.FILM, Pace.HAND);
    }

    /** What is put together from parts answers after them, and the changes follow. */
    @Test
    void theLastListenerIsToldFirstOfAnotherScene() {
        List<String> told = new ArrayList<>();
        model.addOpenListener(() -> told.add("window"));
        model.addOpenListener(() -> told.add("part " + model.studio().velocity().speed()));
        model.addListener(() -> told.add("change"));
        model.set(speed(0.1));
        model.open(speed(0.2), null);
        // the same scene once more is opened, too
        model.open(model.opened(), null);
        assertThat(told).containsExactly("change", "part 0.2", "window", "change", "part 0.2", "window");
    }

    @Test
    void onlyLiveListenersKeepUpWithAFlow() {
        List<Double> live = new ArrayList<>();
        List<Double> others = new ArrayList<>();
        model.addListener(() -> others.add(model.studio().velocity().speed()));
        model.addLiveListener(pace -> live.add(model.studio().velocity().speed()));
        Object ride = new Object();
        for (int i = 1; i <= 9; i++) {
            model.flow(speed(i / 16.0), ride, Pace.RIDE);
        }
        assertThat(live).hasSize(9);
        // at once, and never again in a moment as short as this
        assertThat(others).startsWith(1 / 16.0).hasSizeLessThan(9);
        model.endGesture(ride);
        assertThat(others).endsWith(9 / 16.0);
        int told = others.size();
        model.endGesture(ride);
        assertThat(others).hasSize(told);
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0));
        assertThat(others).endsWith(0.0);
    }

    /** The scene may go on changing while the file is written. */
    @Test
    void whatWasSavedALittleWhileAgoHasItsFileToo() {
        Object animation = new Object();
        model.adjust(speed(0.1), animation);
        Studio written = model.studio();
        model.adjust(speed(0.2), animation);
        model.saved(written, Path.of("a.json"));
        assertThat(model.file()).isEqualTo(Path.of("a.json"));
        assertThat(model.isModified()).isTrue();
        model.reset();
        assertThat(model.studio()).isEqualTo(speed(0.1));
        assertThat(model.isModified()).isFalse();
    }

    @Test
    void whatChangesNothingIsNoStep() {
        AtomicInteger told = new AtomicInteger();
        model.addListener(told::incrementAndGet);
        model.set(speed(0));
        assertThat(model.canUndo()).isFalse();
        assertThat(told).hasValue(0);
    }

    @Test
    void resetGoesBackToWhatWasOpenedAndCanBeUndone() {
        model.open(speed(0.5), Path.of("a.json"));
        model.set(speed(0.6));
        model.set(speed(0.7));
        assertThat(model.isModified()).isTrue();
        model.reset();
        assertThat(model.studio()).isEqualTo(speed(0.5));
        assertThat(model.isModified()).isFalse();
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0.7));
    }

    @Test
    void undoOfOpeningGoesBackToTheFileBefore() {
        model.saved(model.studio(), Path.of("first.json"));
        model.open(speed(0.5), Path.of("second.json"));
        model.undo();
        assertThat(model.file()).isEqualTo(Path.of("first.json"));
        assertThat(model.studio()).isEqualTo(speed(0));
        assertThat(model.isModified()).isFalse();
        model.set(speed(0.1));
        model.reset();
        assertThat(model.studio()).isEqualTo(speed(0));
        model.undo();
        model.undo();
        model.redo();
        model.redo();
        assertThat(model.studio()).isEqualTo(speed(0));
        assertThat(model.file()).isEqualTo(Path.of("first.json"));
    }

    @Test
    void undoneAfterSavingElsewhereIsOfTheNewFile() {
        model.open(speed(0.5), Path.of("a.json"));
        model.set(speed(0.6));
        model.saved(model.studio(), Path.of("b.json"));
        model.undo();
        assertThat(model.file()).isEqualTo(Path.of("b.json"));
        assertThat(model.studio()).isEqualTo(speed(0.5));
        assertThat(model.isModified()).isTrue();
        model.undo();
        assertThat(model.file()).as("the scene before it had no file").isNull();
        assertThat(model.isModified()).isFalse();
        model.redo();
        model.redo();
        assertThat(model.isModified()).isFalse();
        model.set(speed(0.7));
        model.reset();
        assertThat(model.studio()).isEqualTo(speed(0.6));
        assertThat(model.file()).isEqualTo(Path.of("b.json"));
    }
}
