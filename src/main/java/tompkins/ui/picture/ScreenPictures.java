package tompkins.ui.picture;

import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.SwingUtilities;

/**
 * Turns pictures into images no larger than they are shown, on a thread of its own, and hands the newest to the event
 * thread. However fast pictures come, the event thread has only one at a time to paint.
 */
public final class ScreenPictures implements AutoCloseable {

    /** The mean number of samples of a pixel with which a picture shows what there is to see. */
    private static final double ENOUGH_TO_BEGIN = 1.0 / 16;

    /** What is wanted: pictures, and the room in which they are shown, which is null while it is unknown. */
    private record Wanted(Picture now, Picture other, Room room, boolean difference) {}

    private final AtomicReference<ScreenPicture> ready = new AtomicReference<>();
    private final Asker worker;
    private final Consumer<ScreenPicture> screen;
    private Wanted wanted = new Wanted(null, null, null, false);
    private Wanted doneFor;
    private ScreenPicture done = ScreenPicture.EMPTY;

    /** Done as soon as the first picture is on the screen. */
    private final CompletableFuture<Void> begun = new CompletableFuture<>();

    /** Hands images to {@code screen} on the event thread; its own thread tells {@code failures} about trouble. */
    public ScreenPictures(Consumer<ScreenPicture> screen, Consumer<Throwable> failures) {
        this.screen = screen;
        worker = new Asker("tompkins-screen", failures);
    }

    /**
     * There is a better picture. Called by a thread of its renderer, which waits with finer ones until the first is on
     * the screen: a window that is still being built needs the processors, and may want another size.
     */
    public void setNow(Picture picture) {
        want(old -> new Wanted(picture, old.other, old.room, old.difference));
        if (picture.samples() >= ENOUGH_TO_BEGIN) {
            // the screen may never take one
            begun.completeOnTimeout(null, 1, TimeUnit.SECONDS).join();
        }
    }

    /** There is another picture to compare with, or none. Called by any thread. */
    public void setOther(Picture picture) {
        want(old -> picture == old.other ? old : new Wanted(old.now, picture, old.room, old.difference));
    }

    /** Whether the difference is wanted, too. */
    public void setDifference(boolean difference) {
        want(old -> new Wanted(old.now, old.other, old.room, difference));
    }

    /** There is another room for each picture. */
    public void setRoom(Room room) {
        want(old -> room.equals(old.room) ? old : new Wanted(old.now, old.other, room, old.difference));
    }

    private synchronized void want(UnaryOperator<Wanted> change) {
        Wanted before = wanted;
        Wanted order = change.apply(before);
        wanted = order;
        if (order != before && order.now != null && order.room != null) {
            worker.submit(() -> prepare(order));
        }
    }

    private void prepare(Wanted order) {
        boolean sameUse = doneFor != null && doneFor.room.equals(order.room) && doneFor.difference == order.difference;
        BufferedImage now = sameUse && order.now == done.now() ? done.nowImage() : image(order.now, order);
        BufferedImage other = null;
        if (order.other != null && size(order.now, order).equals(size(order.other, order))) {
            boolean sameOther = sameUse && order.other == done.other() && done.otherImage() != null;
            other = sameOther ? done.otherImage() : image(order.other, order);
        }
        BufferedImage difference = order.difference && other != null ? ScreenPicture.difference(now, other) : null;
        done = new ScreenPicture(order.now, now, order.other, other, difference);
        doneFor = order;
        if (ready.getAndSet(done) == null) {
            SwingUtilities.invokeLater(() -> {
                screen.accept(ready.getAndSet(null));
                begun.complete(null);
            });
        }
    }

    private static BufferedImage image(Picture picture, Wanted order) {
        BufferedImage levels = picture.levels();
        Dimension fitted = size(picture, order);
        // The display enlarges a picture itself in a fifth of the time, but two that are subtracted need the same size.
        boolean enlarged = fitted.width >= levels.getWidth() && fitted.height >= levels.getHeight();
        return enlarged && !order.difference ? levels : ScreenPicture.scaled(levels, fitted);
    }

    /** The size of a picture on the canvas. Only pictures of the same size there can be compared. */
    private static Dimension size(Picture picture, Wanted order) {
        return order.room.sizeOf(picture.studio().settings());
    }

    @Override
    public void close() {
        worker.close();
    }
}
