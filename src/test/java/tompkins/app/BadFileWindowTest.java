package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dialog;
import java.awt.Window;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ui.Components;
import tompkins.ui.Displays;
import tompkins.ui.NeedsDisplay;
import tompkins.ui.WindowDriver;

/** A double click on a bad file shows no console: the window says what is wrong. */
@NeedsDisplay
class BadFileWindowTest {

    @AfterEach
    void close() {
        WindowDriver.onEventThread(() -> Stream.of(Window.getWindows()).forEach(Window::dispose));
    }

    @ParameterizedTest
    @ValueSource(strings = {"/", "no-such.json"})
    void theWindowOpensAndSaysWhatIsWrong(String name) {
        ProgramRun run = ProgramRun.of(Displays::usable, name);

        assertThat(run.code()).isEqualTo(Failures.WINDOW_IS_OPEN);
        String printed = run.err().lines().findFirst().orElseThrow().replaceFirst("^tompkins: ", "");
        WindowDriver.await("the message", () -> dialogs().findAny().isPresent());
        assertThat(WindowDriver.onEventThread(() -> String.join(
                        " ",
                        Components.messages(dialogs().findAny().orElseThrow()).toList())))
                .isEqualTo(printed);
    }

    private static Stream<Dialog> dialogs() {
        return Stream.of(Window.getWindows())
                .filter(Window::isShowing)
                .filter(Dialog.class::isInstance)
                .map(Dialog.class::cast);
    }
}
