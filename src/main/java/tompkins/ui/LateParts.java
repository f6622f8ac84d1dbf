package tompkins.ui;

import java.awt.Image;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import tompkins.studio.Studio;

/**
 * What a window has, but not from the beginning: the examples in its menu and its icon. Both are made away from the
 * event thread and after the first picture, so that the picture does not wait for them.
 */
final class LateParts {

    /** They do not wait longer than this for a picture, for it may never come. */
    private static final int LONGEST_WAIT_SECONDS = 2;

    private final CountDownLatch firstPicture = new CountDownLatch(1);
    private final Consumer<List<Studio>> menu;
    private final Consumer<List<Image>> window;

    /** Parts that the menu of examples and a window are given by the event thread. */
    LateParts(Consumer<List<Studio>> menu, Consumer<List<Image>> window) {
        this.menu = menu;
        this.window = window;
    }

    /** There is a first picture, or there will be none. Called any number of times. */
    void firstPictureDone() {
        firstPicture.countDown();
    }

    /** Makes them when it is time to. Returns at once. */
    void prepare(Supplier<List<Studio>> examples) {
        Thread thread = new Thread(() -> make(examples), "tompkins-late");
        thread.setDaemon(true);
        thread.start();
    }

    private void make(Supplier<List<Studio>> examples) {
        try {
            firstPicture.await(LONGEST_WAIT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            return;
        }
        List<Studio> scenes = examples.get();
        SwingUtilities.invokeLater(() -> menu.accept(scenes));
        List<Image> icon = WindowIcon.images();
        SwingUtilities.invokeLater(() -> window.accept(icon));
    }
}
