package tompkins.ui;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;

/** Whether there is a screen. */
public final class Displays {

    private Displays() {}

    /** Whether a window can be opened: there is a display, it answers, and the libraries for it are installed. */
    public static boolean usable() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (AWTError | RuntimeException | LinkageError dead) {
            return false;
        }
    }
}
