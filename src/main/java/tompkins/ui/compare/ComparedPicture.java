package tompkins.ui.compare;

import java.awt.Dimension;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import tompkins.studio.Studio;
import tompkins.ui.model.Pace;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.RenderController;
import tompkins.ui.picture.ScreenPictures;

/** The picture with which that of the studio is compared: one of a changed studio, or one that was kept. */
public final class ComparedPicture implements AutoCloseable {

    /** How many times as long as a picture takes none is taken on a ride. */
    private static final int RESTS = 3;

    /** It is not seen to stand still, in nanoseconds. */
    private static final long LONGEST_REST = 300_000_000;

    private final StudioModel model;
    private final ScreenPictures screen;
    private final Function<Studio, Dimension> sizes;
    private final RenderController controller;
    private Compared compared = Compared.NOTHING;
    private Studio studio;
    private Dimension size;
    private Picture kept;

    /** How soon it was wanted when it was asked for. */
    private Pace asked;

    /** When it may be asked for again on a ride, by the clock of {@link System#nanoTime}. */
    private long again = System.nanoTime();

    /** The studio of a camera at rest where one on a ride is; gives null where there is no ride. */
    private Supplier<Studio> rideAtRest = () -> null;

    /**
     * The picture beside that of a model.
     *
     * @param sizes says in which size the picture of a studio is taken
     * @param failed notified of what goes wrong, by any thread
     */
    public ComparedPicture(
            StudioModel model, ScreenPictures screen, Function<Studio, Dimension> sizes, Consumer<Throwable> failed) {
        this.model = model;
        this.screen = screen;
        this.sizes = sizes;
        controller = new RenderController(this::show, failed);
    }

    /** Chooses what is compared from now on. */
    public void choose(Compared other) {
        compared = other;
        render(Pace.HAND);
    }

    /** Lets a camera at rest be where one on a ride is; the supplier gives null where there is no ride. */
    public void setRideAtRest(Supplier<Studio> atRest) {
        rideAtRest = atRest;
    }

    /** The name of the picture; null if there is none. */
    public String name() {
        return compared.name();
    }

    /**
     * Makes the picture that is compared with the one of the current studio, unless it is there already.
     *
     * @param pace how soon it has to come
     */
    public void render(Pace pace) {
        Studio wanted = wanted();
        if (wanted == null) {
            stop();
            screen.setOther(null);
        } else if (mayRender(pace) && !(sizes.apply(wanted).equals(size) && isAskedFor(wanted, pace))) {
            studio = wanted;
            asked = pace;
            size = sizes.apply(wanted);
            if (kept != null && kept.complete() && studio == kept.studio() && kept.isOfSize(size)) {
                controller.stop();
                screen.setOther(kept);
            } else {
                controller.show(studio, size, asked);
            }
        }
    }

    /** Who steers looks at the picture in front of him: the other one gets a part of the time. */
    private boolean mayRender(Pace pace) {
        boolean goesOn = pace.isGlimpse() && asked != null && asked.isGlimpse();
        return !goesOn || !controller.isBusy() && System.nanoTime() - again >= 0;
    }

    private Studio wanted() {
        Studio onRide = compared.other() == ComparePanel.Other.AT_REST ? rideAtRest.get() : null;
        if (onRide != null) {
            return onRide;
        }
        return compared.other() == ComparePanel.Other.KEPT_PICTURE && kept != null
                ? kept.studio()
                : compared.studio(model.studio());
    }

    /** Whether the picture is there or on its way; one that was asked for on a ride is no whole picture. */
    private boolean isAskedFor(Studio wanted, Pace pace) {
        return wanted.equals(studio) && (!asked.isGlimpse() || pace.isGlimpse());
    }

    private void show(Picture picture) {
        SwingUtilities.invokeLater(() -> {
            // what is no longer wanted may still arrive
            if (picture.studio().equals(studio)) {
                screen.setOther(picture);
                again = System.nanoTime()
                        + Math.min(LONGEST_REST, RESTS * picture.time().toNanos());
            }
        });
    }

    /** Keeps a picture, so that others can be compared with it. */
    public void keep(Picture picture) {
        kept = picture;
    }

    /** Ends the work on the picture; what is there stays until the next change. */
    public void stop() {
        studio = null;
        controller.stop();
    }

    @Override
    public void close() {
        controller.close();
    }
}
