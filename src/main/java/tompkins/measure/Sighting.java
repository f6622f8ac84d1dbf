package tompkins.measure;

import org.joml.Vector3dc;
import tompkins.spacetime.Event;
import tompkins.spacetime.IdentityTransformation;
import tompkins.studio.Studio;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/**
 * What a place of a picture shows: its traced ray through the centre of the lens, in the middle of the exposure, and
 * what that meets last.
 *
 * @param studio the studio of the picture
 * @param x place in pixels; the centre of pixel (i, j) is (i + 1/2, j + 1/2)
 * @param y place in pixels
 * @param life the life of the ray; null if it never crosses the shutter
 */
public record Sighting(Studio studio, double x, double y, RayLife life) {

    /** Follows the ray of a place. */
    public static Sighting of(RenderPlan plan, double x, double y) {
        return new Sighting(plan.studio(), x, y, RayLife.of(plan, x, y, 0, 0));
    }

    /** Follows the ray of the centre of a pixel. */
    public static Sighting ofPixel(RenderPlan plan, int column, int row) {
        return of(plan, column + 0.5, row + 0.5);
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
    public RayLife.Encounter hit() {
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

    /** The frequency that the camera sees, divided by that in the scene frame; NaN without a ray. */
    public double dopplerFactor() {
        return life == null ? Double.NaN : life.frequencyRatio();
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

    /** Whether what is seen moves with the camera. */
    public boolean isBeforeLens() {
        return hit() != null && hit().frame() == Frame.CAMERA;
    }

    private Vector3dc ahead() {
        return studio.sceneFromCamera() instanceof IdentityTransformation
                ? null
                : studio.velocity().direction();
    }
}
