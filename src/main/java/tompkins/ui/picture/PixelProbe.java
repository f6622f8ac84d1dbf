package tompkins.ui.picture;

import java.awt.geom.Point2D;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.joml.Vector3dc;
import tompkins.camera.FocusDistance;
import tompkins.measure.Angles;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.studio.Studio;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/**
 * Follows the ray of the pixel under the mouse, on a thread of its own: what it hits, where and when, in both frames.
 */
public final class PixelProbe implements AutoCloseable {

    /**
     * What lies under a pixel.
     *
     * @param column column of the pixel
     * @param row row of the pixel
     * @param life the life of its ray through the centre of the lens; null if it never crosses the shutter
     * @param object what was hit last, or null for the background
     * @param inScene where and when, in the scene frame; null if nothing was hit
     * @param inCamera the same event in the camera frame; null if nothing was hit
     * @param angleDegrees angle between the look direction and the camera's velocity, in the camera frame; NaN at rest
     * @param sceneAngleDegrees the same angle in the scene frame; NaN at rest, and for a ray that ends in the camera
     *     frame
     * @param frequencyRatio frequency in the camera frame divided by that in the scene frame
     * @param diagrams the life in space and time, in each frame; empty if there is none
     */
    public record Reading(
            int column,
            int row,
            RayLife life,
            String object,
            Event inScene,
            Event inCamera,
            double angleDegrees,
            double sceneAngleDegrees,
            double frequencyRatio,
            Map<Frame, SpaceTimeDiagram> diagrams) {

        /** The same as the reading of another pixel, such as that of the photograph in its own size. */
        Reading ofPixel(int itsColumn, int itsRow) {
            return new Reading(
                    itsColumn,
                    itsRow,
                    life,
                    object,
                    inScene,
                    inCamera,
                    angleDegrees,
                    sceneAngleDegrees,
                    frequencyRatio,
                    diagrams);
        }
    }

    private record Question(Picture picture, Point2D place, Consumer<Reading> answer) {}

    private final NewestFirst<Question> worker;

    /** A probe; its thread tells {@code failures} about questions that could not be answered. */
    public PixelProbe(Consumer<Throwable> failures) {
        worker = new NewestFirst<>("tompkins-probe", PixelProbe::answer, (question, error) -> failures.accept(error));
    }

    /**
     * Reads a place of a picture, in pixels of its photograph; the answer comes on the event thread, unless a newer
     * question comes first.
     */
    public void ask(Picture picture, Point2D place, Consumer<Reading> answer) {
        worker.submit(new Question(picture, place, answer));
    }

    private static void answer(Question question) {
        Point2D place = question.place;
        Reading reading = read(question.picture.plan(), question.picture.inPixels(place))
                .ofPixel((int) place.getX(), (int) place.getY());
        SwingUtilities.invokeLater(() -> question.answer.accept(reading));
    }

    /** Reads a place of a plan's picture, in pixels. */
    static Reading read(RenderPlan plan, Point2D place) {
        int column = (int) place.getX();
        int row = (int) place.getY();
        RayLife life = RayLife.of(plan, place.getX(), place.getY(), 0, 0);
        if (life == null) {
            return new Reading(column, row, null, null, null, null, Double.NaN, Double.NaN, 1, Map.of());
        }
        RayLife.Encounter end = life.end();
        SpaceTimeTransformation sceneFromCamera = plan.studio().sceneFromCamera();
        Vector3dc velocity = plan.isAtRest() ? null : plan.studio().velocity().direction();
        return new Reading(
                column,
                row,
                life,
                end == null ? null : end.object().description(),
                end == null ? null : end.inScene(sceneFromCamera),
                end == null ? null : end.inCamera(sceneFromCamera),
                Math.toDegrees(Angles.between(life.cameraDirection(), velocity)),
                Math.toDegrees(Angles.between(life.sceneDirection(), velocity)),
                life.frequencyRatio(),
                diagrams(life, plan.studio()));
    }

    private static Map<Frame, SpaceTimeDiagram> diagrams(RayLife life, Studio studio) {
        return Map.of(
                Frame.SCENE, SpaceTimeDiagram.of(life, studio, Frame.SCENE),
                Frame.CAMERA, SpaceTimeDiagram.of(life, studio, Frame.CAMERA));
    }

    /** The distance at which the camera has to be focused for what was read to be sharp, or NaN. */
    public static double depth(RenderPlan plan, Reading reading) {
        if (reading.inCamera() == null) {
            return Double.NaN;
        }
        return FocusDistance.toPoint(plan.studio().camera(), reading.inCamera().position());
    }

    @Override
    public void close() {
        worker.close();
    }
}
