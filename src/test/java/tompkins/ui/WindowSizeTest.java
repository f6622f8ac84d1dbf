package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.ComponentEvent;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import javax.swing.JFrame;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.ui.model.Settings;

/** What is remembered of a window that is maximised, by a frame that does so without a window manager. */
@NeedsDisplay
class WindowSizeTest {

    @TempDir
    private Path folder;

    private FreeFrame frame;
    private WindowSize size;

    /** A frame whose state nobody but its program decides. */
    private static final class FreeFrame extends JFrame {

        private static final long serialVersionUID = 1;

        private int state;

        @Override
        public void setExtendedState(int wish) {
            state = wish;
        }

        @Override
        public int getExtendedState() {
            return state;
        }

        void resize(int width, int height, int newState) {
            state = newState;
            setSize(width, height);
            dispatchEvent(new ComponentEvent(this, ComponentEvent.COMPONENT_RESIZED));
        }
    }

    @BeforeEach
    void open() {
        frame = new FreeFrame();
        frame.setSize(800, 600);
        size = new WindowSize(frame, settings());
    }

    private Settings settings() {
        return new Settings(folder.resolve("window.properties"));
    }

    private void assertRemembered(int width, int height, int state) {
        size.save();
        assertThat(settings().number("width", 0)).isEqualTo(width);
        assertThat(settings().number("height", 0)).isEqualTo(height);
        FreeFrame next = new FreeFrame();
        new WindowSize(next, settings());
        next.dispatchEvent(new WindowEvent(next, WindowEvent.WINDOW_ACTIVATED));
        assertThat(next.getExtendedState()).isEqualTo(state);
    }

    /** Sizes that the window has one after the other, maximised or not, and what is remembered. */
    @ParameterizedTest
    @CsvSource({
        "'900x700, 1600x1000 maximised', 900, 700, true",
        "'1600x1000 maximised, 800x640', 800, 640, false",
        "1600x1000 maximised, 800, 600, true"
    })
    void aMaximisedWindowKeepsItsNormalSize(String sizes, int width, int height, boolean isMaximised) {
        for (String each : sizes.split(", ")) {
            String[] numbers = each.replace(" maximised", "").split("x");
            int state = each.endsWith("maximised") ? JFrame.MAXIMIZED_BOTH : JFrame.NORMAL;
            frame.resize(Integer.parseInt(numbers[0]), Integer.parseInt(numbers[1]), state);
        }
        assertRemembered(width, height, isMaximised ? JFrame.MAXIMIZED_BOTH : JFrame.NORMAL);
    }

    @Test
    void aMinimisedWindowComesBack() {
        frame.setExtendedState(JFrame.ICONIFIED);
        assertRemembered(800, 600, JFrame.NORMAL);
    }
}
