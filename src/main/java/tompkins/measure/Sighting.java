package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3dc;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.spacetime.Event;
import tompkins.spacetime.IdentityTransformation;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/**
 * What a point of a picture shows: its traced ray through the centre of the lens, in the middle of the exposure, and
 * what that meets last.
 *
 * @param studio the studio of the picture
 * @param x position in pixels; the centre of pixel (i, j) is (i + 1/2, j + 1/2)
 * @param y position in pixels
 * @param life the life of the ray; null if it never crosses the shutter
 */
public record Sighting(Studio studio, double x, double y, SampleHistory life) {

    private static final int MOST_OF_LINE = 10_000;

    /** Follows the ray of a point. */
    public static Sighting of(RenderPlan plan, double x, double y) {
        return new Sighting(plan.studio(), x, y, SampleHistory.of(plan, x, y, 0, 0));
    }

    /**
     * What a picture shows along a straight line in it: at as many equal steps as it has pixels, 2 to 10 000 points,
     * both ends among them.
     *
     * @param goesOn asked before each point
     * @return the points from the first end to the second, or null if it was not to go on
     */
    static List<Sighting> along(RenderPlan plan, Vector2dc first, Vector2dc last, BooleanSupplier goesOn) {
        Vector2d way = last.sub(first, new Vector2d()).absolute();
        int count = (int) Math.max(2, Math.min(MOST_OF_LINE, Math.round(Math.max(way.x, way.y)) + 1));
        List<Sighting> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            if (!goesOn.getAsBoolean()) {
                return null;
            }
            Vector2d point = first.lerp(last, i / (count - 1.0), new Vector2d());
            points.add(of(plan, point.x, point.y));
        }
        return points;
    }

    /**
     * Follows the ray of a point through a point on the lens, in units of its radius.
     *
     * @throws InvalidPropertyException if it never crosses the shutter
     */
    static Sighting required(RenderPlan plan, Vector2dc point, double lensX, double lensY) {
        SampleHistory life = SampleHistory.of(plan, point.x(), point.y(), lensX, lensY);
        if (life == null) {
            String here = String.format(
                    Locale.ROOT, "across %.4g, down %.4g", point.x() / plan.width(), point.y() / plan.height());
            throw new InvalidPropertyException("point", "where a ray crosses the shutter", here);
        }
        return new Sighting(plan.studio(), point.x(), point.y(), life);
    }

    /** The unit direction in the camera frame; null without a ray. */
    public Vector3dc cameraDirection() {
        return life == null ? null : life.cameraDirection();
    }

    /** The unit direction with which the ray enters the scene frame; null if it never does. */
    public Vector3dc sceneDirection() {
        return life == null ? null : life.sceneDirection();
    }

    /** What is seen; null for the background, and without a ray. */
    public SampleHistory.Encounter hit() {
        return life == null ? null : life.end();
    }

    /** Where and when the light started, in the scene frame; null if nothing was hit. */
    public Event inScene() {
        return hit() == null ? null : hit().inScene(studio.sceneFromCamera());
    }

    /** Where and when the light started, in the camera frame; null if nothing was hit. */
    public Event inCamera() {
        return hit() == null ? null : hit().inCamera(studio.sceneFromCamera());
    }

    /** The straight distance from the lens to what was hit, in the camera frame; NaN without a hit. */
    public double cameraDistance() {
        Event event = inCamera();
        return event == null
                ? Double.NaN
                : event.position().distance(life.cameraStart().position());
    }

    /** The angle between the look direction and the velocity in the camera frame, in radians; NaN at rest. */
    public double cameraAngle() {
        return Angles.between(cameraDirection(), ahead());
    }

    /** The same angle in the scene frame, in radians; NaN at rest, and for a ray that stays in the camera frame. */
    public double sceneAngle() {
        return Angles.between(sceneDirection(), ahead());
    }

    /**
     * The frequency that the camera sees, divided by that in the rest frame of what is seen: of the object, or of the
     * scene for the background; NaN without light.
     */
    public double dopplerFactor() {
        return life == null ? Double.NaN : life.dopplerFactor();
    }

    /** The frequency that the camera sees, divided by that in the scene frame; NaN without a ray. */
    public double sceneDopplerFactor() {
        return life == null ? Double.NaN : life.sceneDopplerFactor();
    }

    /** The light that is seen, before exposure; none without a ray. */
    public Colour colour() {
        return life == null ? Colour.BLACK : life.colour();
    }

    /** Its luminance; 1 is white. */
    public double brightness() {
        return Colour.luminance(colour().red(), colour().green(), colour().blue());
    }

    /** Whether two sightings end on objects that rest in one frame. */
    public boolean sharesFrame(Sighting other) {
        return hit() != null
                && other.hit() != null
                && hit().frame() == other.hit().frame()
                && (hit().rest().motion() == null
                        ? other.hit().rest().motion() == null
                        : hit().rest().motion().equals(other.hit().rest().motion()));
    }

    /** Whether what is seen turns. */
    boolean turns() {
        return hit() != null && hit().rest().velocity() != null;
    }

    private Vector3dc ahead() {
        return studio.sceneFromCamera() instanceof IdentityTransformation
                ? null
                : studio.velocity().direction();
    }
}
