package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.ComponentEvent;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import javax.swing.JFrame;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
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

    @Test
    void aMaximisedWindowKeepsTheSizeThatItHadBefore() {
        frame.resize(900, 700, JFrame.NORMAL);
        frame.resize(1600, 1000, JFrame.MAXIMIZED_BOTH);
        assertRemembered(900, 700, JFrame.MAXIMIZED_BOTH);
    }

    @Test
    void aWindowThatIsMaximisedNoMoreKeepsItsOwnSize() {
        frame.resize(1600, 1000, JFrame.MAXIMIZED_BOTH);
        frame.resize(800, 640, JFrame.NORMAL);
        assertRemembered(800, 640, JFrame.NORMAL);
    }

    @Test
    void aWindowThatComesUpMaximisedKeepsItsNormalSize() {
        frame.resize(1600, 1000, JFrame.MAXIMIZED_BOTH);
        assertRemembered(800, 600, JFrame.MAXIMIZED_BOTH);
    }

    @Test
    void aMinimisedWindowComesBack() {
        frame.setExtendedState(JFrame.ICONIFIED);
        assertRemembered(800, 600, JFrame.NORMAL);
    }
}
