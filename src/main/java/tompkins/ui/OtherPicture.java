package tompkins.ui;

import java.awt.Dimension;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import tompkins.shutter.Shutter;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.panel.ComparePanel;
import tompkins.ui.panel.Compared;
import tompkins.ui.picture.Pace;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.RenderController;
import tompkins.ui.picture.ScreenPictures;

/** The picture with which that of the current studio is compared. Used by the event thread alone. */
final class OtherPicture implements AutoCloseable {

    private final StudioModel model;
    private final ScreenPictures screen;
    private final Supplier<Pace> pace;
    private final Function<Studio, Dimension> sizes;
    private final RenderController controller;

    /** The studio of a camera at rest where one on a ride is; gives null where there is no ride. */
    private Supplier<Studio> rideAtRest = () -> null;

    private Compared compared = Compared.NOTHING;
    private Studio studio;
    private Dimension size;
    private Picture shown;
    private Picture kept;

    /**
     * No other picture yet.
     *
     * @param screen shows it
     * @param pace how soon a picture of a change has to come
     * @param sizes the size in which the picture of a studio is taken
     * @param failures told why there is no picture, by any thread
     */
    OtherPicture(
            StudioModel model,
            ScreenPictures screen,
            Supplier<Pace> pace,
            Function<Studio, Dimension> sizes,
            Consumer<Throwable> failures) {
        this.model = model;
        this.screen = screen;
        this.pace = pace;
        this.sizes = sizes;
        controller = new RenderController(this::take, failures);
    }

    /** Lets a camera at rest be where one on a ride is; the supplier gives null where there is no ride. */
    void setRideAtRest(Supplier<Studio> atRest) {
        rideAtRest = atRest;
    }

    /** Compares with another picture from now on. */
    void compare(Compared other) {
        compared = other;
    }

    /** What is compared with. */
    Compared compared() {
        return compared;
    }

    /** Keeps a picture, to compare others with it; none if it is null. */
    void keep(Picture picture) {
        kept = picture;
    }

    /** Makes the picture, unless it is there. */
    void render() {
        Studio wanted = wanted();
        if (wanted == null) {
            studio = null;
            shown = null;
            controller.stop();
            screen.setOther(null);
        } else if (!sizes.apply(wanted).equals(size) || !looksAsBefore(wanted)) {
            studio = wanted;
            size = sizes.apply(wanted);
            if (kept != null && studio == kept.studio() && kept.isOfSize(size)) {
                controller.stop();
                screen.setOther(kept);
            } else {
                controller.show(studio, size, pace.get().ofOther());
            }
        }
    }

    private Studio wanted() {
        Studio onRide = compared.other() == ComparePanel.Other.AT_REST ? rideAtRest.get() : null;
        return onRide != null
                ? onRide
                : compared.other() == ComparePanel.Other.KEPT_PICTURE && kept != null
                        ? kept.studio()
                        : compared.studio(model.studio());
    }

    /** Whether the picture is that of a studio, too: on a ride only time may go on, and nothing change with it. */
    private boolean looksAsBefore(Studio wanted) {
        if (wanted.equals(studio)) {
            return true;
        }
        if (pace.get() != Pace.RIDE
                || shown == null
                || !shown.studio().equals(studio)
                || !shown.plan().isStill()) {
            return false;
        }
        Shutter shutter = wanted.camera().shutter();
        Shutter before = studio.camera().shutter();
        return shutter.hasOpeningTime()
                && before.hasOpeningTime()
                && studio.equals(
                        wanted.withCamera(wanted.camera().withShutter(shutter.openedAt(before.openingTime()))));
    }

    private void take(Picture picture) {
        SwingUtilities.invokeLater(() -> {
            // what is no longer wanted may still arrive
            if (picture.studio().equals(studio)) {
                shown = picture;
                screen.setOther(picture);
            }
        });
    }

    /** Ends the work on the picture; it is made again with the next change. */
    void stop() {
        controller.stop();
        studio = null;
    }

    @Override
    public void close() {
        controller.close();
    }
}
