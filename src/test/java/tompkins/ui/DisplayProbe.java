package tompkins.ui;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.ProcessBuilder.Redirect;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.condition.OS;
import org.junit.platform.launcher.LauncherSession;
import org.junit.platform.launcher.LauncherSessionListener;
import tompkins.RunningJava;

/**
 * Runs tests without a display, unless there is one that answers. Another process asks it, since Java draws nothing any
 * more after it has met a dead one.
 */
public final class DisplayProbe implements LauncherSessionListener {

    private static final String HEADLESS = "java.awt.headless";
    private static final long LONGEST_SECONDS = 120;

    /** Ends with 0 if windows can be opened. */
    public static void main(String[] arguments) {
        System.exit(Displays.usable() ? 0 : 1);
    }

    @Override
    public void launcherSessionOpened(LauncherSession session) {
        String display = System.getenv("DISPLAY");
        if (System.getProperty(HEADLESS) != null) {
            return;
        }
        // windows are tried on Linux
        if (!OS.LINUX.isCurrentOs() || display == null || !answers(display)) {
            System.setProperty(HEADLESS, "true");
        }
    }

    /** Whether windows can be opened on a display of that name. */
    static boolean answers(String display) {
        ProcessBuilder probe =
                new ProcessBuilder(RunningJava.PROGRAM, "-cp", RunningJava.CLASS_PATH, DisplayProbe.class.getName());
        probe.environment().put("DISPLAY", display);
        try {
            Process asking = probe.redirectErrorStream(true)
                    .redirectOutput(Redirect.DISCARD)
                    .start();
            boolean ended = asking.waitFor(LONGEST_SECONDS, TimeUnit.SECONDS);
            asking.destroyForcibly();
            return ended && asking.exitValue() == 0;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException interrupted) {
            throw new IllegalStateException(interrupted);
        }
    }
}
