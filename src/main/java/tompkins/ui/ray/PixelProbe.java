package tompkins.ui.ray;

import java.awt.geom.Point2D;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import tompkins.camera.FocusDistance;
import tompkins.camera.SamplePositions;
import tompkins.measure.RayCone;
import tompkins.measure.Sighting;
import tompkins.spacetime.Event;
import tompkins.studio.Studio;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;
import tompkins.ui.picture.NewestFirst;
import tompkins.ui.picture.Picture;

/**
 * Follows the ray of the pixel under the mouse, on a thread of its own: what it hits, where and when, in both frames.
 */
public final class PixelProbe implements AutoCloseable {

    /**
     * What lies under a pixel.
     *
     * @param column column of the pixel
     * @param row row of the pixel
     * @param sighting what is seen there
     * @param diagrams the history of the ray in space and time, in each frame; empty if there is none
     */
    public record Reading(int column, int row, Sighting sighting, Map<Frame, SpaceTimeDiagram> diagrams) {}

    /** How many rays a cone has. */
    private static final int RAYS_OF_CONE = 12;

    private final NewestFirst worker;

    /** A probe; its thread tells {@code failures} about questions that could not be answered. */
    public PixelProbe(Consumer<Throwable> failures) {
        worker = new NewestFirst("tompkins-probe", failures);
    }

    /**
     * Reads a place of a picture, in pixels of its photograph; the answer comes on the event thread, unless a newer
     * question comes first.
     */
    public void ask(Picture picture, Point2D place, Consumer<Reading> answer) {
        worker.ask(() -> read(picture.plan(), picture.inPixels(place), place), answer);
    }

    /** Follows a cone of rays around that of a place of a picture, in the middle of the exposure; answers as above. */
    void askCone(Picture picture, Point2D place, Consumer<List<RayLife>> answer) {
        Point2D middle = picture.inPixels(place);
        worker.ask(
                () -> RayCone.around(
                        picture.plan(), middle.getX(), middle.getY(), RAYS_OF_CONE, SamplePositions.MIDDLE),
                answer);
    }

    /** Reads a place of a plan's picture, in pixels, as that of a pixel of the photograph in its own size. */
    static Reading read(RenderPlan plan, Point2D place, Point2D pixel) {
        Sighting sighting = Sighting.of(plan, place.getX(), place.getY());
        return new Reading(
                (int) pixel.getX(),
                (int) pixel.getY(),
                sighting,
                sighting.life() == null ? Map.of() : diagrams(sighting.life(), plan.studio()));
    }

    private static Map<Frame, SpaceTimeDiagram> diagrams(RayLife life, Studio studio) {
        return Map.of(
                Frame.SCENE, SpaceTimeDiagram.of(life, studio, Frame.SCENE),
                Frame.CAMERA, SpaceTimeDiagram.of(life, studio, Frame.CAMERA));
    }

    /** The distance at which the camera has to be focused for what was read to be sharp, or NaN. */
    public static double depth(RenderPlan plan, Reading reading) {
        Event seen = reading.sighting().inCamera();
        return seen == null ? Double.NaN : FocusDistance.toPoint(plan.studio().camera(), seen.position());
    }

    @Override
    public void close() {
        worker.close();
    }
}
