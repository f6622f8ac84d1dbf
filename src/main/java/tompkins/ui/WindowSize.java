package tompkins.ui;

import java.awt.Dimension;
import java.awt.Frame;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JFrame;
import tompkins.ui.model.Settings;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Screens;

/** Remembers in the settings whether a window is maximised, and how large it is when it is not. */
final class WindowSize {

    /** Sizes of the window at first, in sizes of its type. */
    private static final double WIDTH = 84;

    private static final double HEIGHT = 63;
    private static final double MINIMUM_WIDTH = 40;
    private static final double MINIMUM_HEIGHT = 24;
    private static final String MAXIMISED = "maximised";

    private final JFrame frame;
    private final Settings settings;
    private Dimension normal;

    /** Follows a window that has its normal size, and maximises it as it was when it was closed. */
    WindowSize(JFrame frame, Settings settings) {
        this.frame = frame;
        this.settings = settings;
        normal = frame.getSize();
        frame.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                // a window over all of a screen has no frame
                boolean coversScreen =
                        frame.getGraphicsConfiguration().getDevice().getFullScreenWindow() == frame;
                if (maximised() == 0 && !coversScreen) {
                    normal = frame.getSize();
                }
            }
        });
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowActivated(WindowEvent event) {
                // a window without its borders would forget its normal size
                frame.removeWindowListener(this);
                frame.setExtendedState(settings.number(MAXIMISED, 0) & Frame.MAXIMIZED_BOTH);
            }
        });
    }

    /** The size that was kept, or the first one. */
    static Dimension kept(JFrame frame, Settings settings) {
        return Screens.atMost(
                frame, settings.number("width", Look.pixels(WIDTH)), settings.number("height", Look.pixels(HEIGHT)));
    }

    /** The size that the window must have, as large as its type asks for. */
    static Dimension least(JFrame frame) {
        return Screens.atMost(frame, Look.pixels(MINIMUM_WIDTH), Look.pixels(MINIMUM_HEIGHT));
    }

    /** The directions in which the window is maximised, as a {@link Frame} counts them; 0 for none. */
    private int maximised() {
        return frame.getExtendedState() & Frame.MAXIMIZED_BOTH;
    }

    /** Writes the present size of the window into the settings. */
    void save() {
        settings.setNumber("width", normal.width);
        settings.setNumber("height", normal.height);
        settings.setNumber(MAXIMISED, maximised());
    }
}
