package tompkins.ui.ray;

import java.awt.geom.Point2D;
import java.util.List;
import java.util.Objects;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import tompkins.camera.SamplePositions;
import tompkins.measure.RayTubes;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.ui.picture.Asker;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.PictureTool;
import tompkins.ui.picture.ScreenPicture;

/**
 * A pinned place of the picture, or of the one beside it: its ray is followed again when the picture changes. It is the
 * tool that pins, which is in the hand if no other is wanted.
 */
public final class PixelPin implements PictureTool {

    /** How many rays a cone has. */
    private static final int RAYS_OF_CONE = 12;

    private final PictureCanvas canvas;
    private final Function<Picture, String> names;
    private final BiConsumer<PixelReading, String> listener;
    private final Asker asker;
    private Pinned now = new Pinned(null, false);

    /** What was pinned before. */
    private Pinned before = now;

    /** A place of the picture, or of the one beside it; null if none is pinned. */
    private record Pinned(Point2D place, boolean inOther) {}

    /** The plan of the picture that was read, and the name of the picture at that time. */
    private RenderPlan readPlan;

    private String readName;

    /**
     * The pin of a canvas, at no place.
     *
     * @param names gives the name of a picture; null for one that is seen alone
     * @param listener notified of what was read, and in which picture; a reading of null says that nothing is pinned
     * @param asker follows the rays
     */
    public PixelPin(
            PictureCanvas canvas,
            Function<Picture, String> names,
            BiConsumer<PixelReading, String> listener,
            Asker asker) {
        this.canvas = canvas;
        this.names = names;
        this.listener = listener;
        this.asker = asker;
    }

    /** Pins a place of the picture, or of the one beside it; no place if it is null. */
    public void set(Point2D place, boolean inOther) {
        before = now;
        now = new Pinned(place, inOther);
        canvas.setPin(place);
        read();
    }

    @Override
    public boolean isWanted() {
        return true;
    }

    @Override
    public void click(Point2D clicked, Picture seen) {
        set(clicked, seen != canvas.shown().now());
    }

    /** Pins again what was pinned before the first click. */
    @Override
    public boolean clickAgain(Point2D clicked, Picture seen) {
        set(before.place, before.inOther);
        return false;
    }

    /** Another picture is on the screen. */
    public void follow() {
        if (now.place != null && !canvas.shown().now().holds(now.place)) {
            set(null, false);
        } else if (now.place != null
                && (picture().plan() != readPlan || !Objects.equals(names.apply(picture()), readName))) {
            read();
        }
    }

    /** Reads the pinned place again, if there is one. */
    public void readAgain() {
        if (now.place != null) {
            read();
        }
    }

    /** Follows a cone of rays around the pinned one; the answer comes on the event thread. */
    public void askCone(Consumer<List<SampleHistory>> answer) {
        Picture picture = picture();
        if (now.place != null && picture != null) {
            Point2D middle = picture.inPixels(canvas.shown().placeIn(picture, now.place));
            asker.ask(RayTubes.class, () -> cone(picture.plan(), middle), answer);
        }
    }

    private static List<SampleHistory> cone(RenderPlan plan, Point2D middle) {
        return RayTubes.cone(plan, middle.getX(), middle.getY(), RAYS_OF_CONE, SamplePositions.MIDDLE);
    }

    private Picture picture() {
        ScreenPicture shown = canvas.shown();
        return now.inOther && shown.otherImage() != null ? shown.other() : shown.now();
    }

    private void read() {
        Picture picture = picture();
        if (now.place == null || picture == null) {
            // the plan may hold a large scene
            readPlan = null;
            asker.drop(this);
            listener.accept(null, null);
            return;
        }
        readPlan = picture.plan();
        String name = names.apply(picture);
        readName = name;
        Point2D own = canvas.shown().placeIn(picture, now.place);
        asker.ask(this, () -> PixelReading.of(picture, own), reading -> listener.accept(reading, name));
    }
}
