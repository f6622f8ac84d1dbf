package tompkins.ui.picture;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Texts;

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
            double frequencyRatio) {}

    /** Shows that what is told belongs to a weaker branch of a ray. */
    private static final String BRANCH_INDENT = "\u2003";

    private record Question(RenderPlan plan, Point2D place, Consumer<Reading> answer) {}

    private final NewestFirst<Question> worker;

    /** A probe; {@code failures} is told by its thread of questions that could not be answered. */
    public PixelProbe(Consumer<Throwable> failures) {
        worker = new NewestFirst<>("tompkins-probe", PixelProbe::answer, (question, error) -> failures.accept(error));
    }

    /** Reads a place of a plan's picture; the answer comes on the event thread, unless a newer question comes first. */
    public void ask(RenderPlan plan, Point2D place, Consumer<Reading> answer) {
        worker.submit(new Question(plan, place, answer));
    }

    private static void answer(Question question) {
        Reading reading = read(question.plan, question.place);
        SwingUtilities.invokeLater(() -> question.answer.accept(reading));
    }

    /** Reads a place of a plan's picture, in pixels. */
    static Reading read(RenderPlan plan, Point2D place) {
        int column = (int) place.getX();
        int row = (int) place.getY();
        RayLife life = RayLife.of(plan, place.getX(), place.getY(), 0, 0);
        if (life == null) {
            return new Reading(column, row, null, null, null, null, Double.NaN, Double.NaN, 1);
        }
        List<RayLife.Encounter> hits = life.mainHits();
        RayLife.Encounter end = hits.isEmpty() ? null : hits.get(hits.size() - 1);
        SpaceTimeTransformation sceneFromCamera = plan.studio().sceneFromCamera();
        boolean inCameraFrame = end != null && end.frame() == Frame.CAMERA;
        Event inScene = end == null ? null : inCameraFrame ? sceneFromCamera.transform(end.event()) : end.event();
        Event inCamera = end == null
                ? null
                : inCameraFrame ? end.event() : sceneFromCamera.inverse().transform(end.event());
        Vector3dc velocity = plan.isAtRest() ? null : plan.studio().velocity().direction();
        String object = end == null || life.reachesBackground() ? null : end.object();
        return new Reading(
                column,
                row,
                life,
                object,
                object == null ? null : inScene,
                object == null ? null : inCamera,
                degreesBetween(life.cameraDirection(), velocity),
                degreesBetween(life.sceneDirection(), velocity),
                life.frequencyRatio());
    }

    /** NaN if one of the directions is null. */
    private static double degreesBetween(Vector3dc first, Vector3dc second) {
        if (first == null || second == null) {
            return Double.NaN;
        }
        Vector3d across = new Vector3d(first).cross(second);
        return Math.toDegrees(Math.atan2(across.length(), first.dot(second)));
    }

    /** The distance at which the camera has to be focused for what was read to be sharp, or NaN. */
    public static double depth(RenderPlan plan, Reading reading) {
        if (reading.inCamera() == null) {
            return Double.NaN;
        }
        return plan.studio().camera().focusDistanceOf(reading.inCamera().position());
    }

    /** The life of a ray in lines, as the command "trace" tells it. */
    public static List<String> story(Reading reading) {
        List<String> lines = new ArrayList<>();
        lines.add(Texts.get("probe.pixel", reading.column, reading.row));
        RayLife life = reading.life;
        if (life == null) {
            lines.add(Texts.get("probe.noShutter"));
            return lines;
        }
        lines.add(Texts.get("probe.backwards"));
        lines.add(Texts.get("probe.cameraStart", Numbers.brief(life.cameraStart())));
        lines.add(Texts.get("probe.direction", Numbers.brief(life.cameraDirection())));
        boolean crossed = false;
        for (RayLife.Encounter hit : life.hits()) {
            if (!crossed && hit.branch() == 0 && hit.frame() == Frame.SCENE) {
                crossed = true;
                addCrossing(lines, life);
            }
            String indent = BRANCH_INDENT.repeat(hit.branch());
            lines.add(indent
                    + Texts.get(
                            hit.frame() == Frame.SCENE ? "probe.hitScene" : "probe.hitCamera",
                            hit.object(),
                            Numbers.brief(hit.distance()),
                            Numbers.brief(hit.event())));
            if (hit.share() < 1) {
                lines.add(indent + Texts.get("probe.share", Numbers.brief(hit.share(), 4)));
            }
        }
        if (!crossed && life.sceneStart() != null) {
            addCrossing(lines, life);
        }
        if (reading.object == null) {
            lines.add(Texts.get("probe.background"));
        }
        lines.add(Texts.get(
                "probe.colour",
                Numbers.brief(life.colour().red(), 4),
                Numbers.brief(life.colour().green(), 4),
                Numbers.brief(life.colour().blue(), 4)));
        return lines;
    }

    private static void addCrossing(List<String> lines, RayLife life) {
        lines.add(Texts.get("probe.sceneStart", Numbers.brief(life.sceneStart())));
        lines.add(Texts.get("probe.direction", Numbers.brief(life.sceneDirection())));
        lines.add(Texts.get("probe.ratio", Numbers.brief(life.frequencyRatio())));
    }

    @Override
    public void close() {
        worker.close();
    }
}
