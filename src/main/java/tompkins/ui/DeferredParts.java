package tompkins.ui;

import java.awt.Image;
import java.lang.reflect.InvocationTargetException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import tompkins.studio.Studio;

/**
 * What a window has, but not from the beginning: its panel, the examples in its menu, and its icon. They come after the
 * first picture, so that it does not wait for them; whatever can be made away from the event thread is made there.
 */
final class DeferredParts {

    /** How long they wait for a picture at most, because it may never come. */
    static final Duration LONGEST_WAIT = Duration.ofSeconds(1);

    private final CountDownLatch firstPicture = new CountDownLatch(1);
    private final Duration longestWait;
    private final Runnable panel;
    private final Consumer<List<Studio>> menu;
    private final Consumer<List<Image>> window;

    /**
     * Parts that a window is given by the event thread.
     *
     * @param panel makes the panel
     * @param menu takes the examples
     * @param window takes the icon
     */
    DeferredParts(Duration longestWait, Runnable panel, Consumer<List<Studio>> menu, Consumer<List<Image>> window) {
        this.longestWait = longestWait;
        this.panel = panel;
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
            firstPicture.await(longestWait.toMillis(), TimeUnit.MILLISECONDS);
            SwingUtilities.invokeLater(panel);
            // only until it is there: waiting for the panel itself would hide its errors from the code that reports
            // them
            SwingUtilities.invokeAndWait(() -> {});
        } catch (InterruptedException | InvocationTargetException e) {
            return;
        }
        List<Studio> scenes = examples.get();
        SwingUtilities.invokeLater(() -> menu.accept(scenes));
        List<Image> icon = WindowIcon.images();
        SwingUtilities.invokeLater(() -> window.accept(icon));
    }
}
