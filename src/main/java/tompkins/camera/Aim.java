package tompkins.camera;

import java.util.List;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.spacetime.IdentityTransformation;

/**
 * Where a camera looks, as two angles about its top direction, and how it is turned so that something is seen at a
 * position of the picture. The top direction stays, so that a level horizon stays level.
 *
 * @param right angle about the top direction, towards the right, from where the camera looked at first; radians
 * @param up angle above the plane across the top direction; radians
 */
public record Aim(double right, double up) {

    /** Straight ahead. */
    public static final Aim NONE = new Aim(0, 0);

    /** The steepest that a camera looks: straight along its top direction, right and left have no meaning. */
    public static final double STEEPEST = Math.toRadians(89.5);

    /** How far up a camera looks. */
    private static double elevation(Camera camera) {
        return elevation(camera, Vectors.unit(camera.viewDirection()));
    }

    private static double elevation(Camera camera, Vector3dc unit) {
        return Math.asin(Math.max(-1, Math.min(1, unit.dot(Vectors.unit(camera.topDirection())))));
    }

    /** The angles by which a camera has to be turned to look where another one looks; both have the same top. */
    public static Aim between(Camera from, Camera to) {
        Vector3d view = Vectors.unit(to.viewDirection());
        Vector3dc right = from.rightDirection();
        Vector3d level = right.cross(Vectors.unit(from.topDirection()), new Vector3d());
        return new Aim(Math.atan2(view.dot(right), view.dot(level)), elevation(from, view) - elevation(from));
    }

    /** A camera, turned by these angles: to the right about its top direction, and up. */
    public Camera turn(Camera camera) {
        return turned(camera, right, elevation(camera) + up);
    }

    /** A camera that looks to the right of its present direction by an angle, at a given elevation. */
    private static Camera turned(Camera camera, double right, double elevation) {
        double steep = Math.max(-STEEPEST, Math.min(STEEPEST, elevation));
        Vector3d top = Vectors.unit(camera.topDirection());
        Vector3dc across = camera.rightDirection();
        Vector3d level = across.cross(top, new Vector3d());
        Vector3d view = level.mul(Math.cos(steep) * Math.cos(right))
                .fma(Math.cos(steep) * Math.sin(right), across)
                .fma(Math.sin(steep), top);
        return CameraMotion.turned(camera, view, camera.topDirection());
    }

    /**
     * A camera, turned so that a direction is seen at a position of its picture, as far as that goes with a level
     * horizon.
     *
     * @param direction unit vector in the camera frame
     * @param position the position
     */
    public static Camera at(Camera camera, Vector3dc direction, PicturePosition position) {
        Vector3dc seen = position.direction(camera);
        Vector3dc across = camera.rightDirection();
        double seenRight = seen.dot(across);
        double seenUp = seen.dot(camera.upDirection());
        double seenAhead = seen.dot(Vectors.unit(camera.viewDirection()));
        Vector3d top = Vectors.unit(camera.topDirection());
        // with the elevation e of the view: seenUp cos e + seenAhead sin e is the height of the direction
        double reach = Math.hypot(seenUp, seenAhead);
        double height = Math.max(-reach, Math.min(reach, direction.dot(top)));
        double angle = Math.asin(reach == 0 ? 0 : height / reach);
        double offset = Math.atan2(seenUp, seenAhead);
        double elevation = nearer(angle - offset, Math.PI - angle - offset, elevation(camera));
        double ahead = seenAhead * Math.cos(elevation) - seenUp * Math.sin(elevation);
        Vector3d level = across.cross(top, new Vector3d());
        double right = Math.atan2(direction.dot(across), direction.dot(level)) - Math.atan2(seenRight, ahead);
        return turned(camera, right, elevation);
    }

    /** A camera whose middle looks along a direction of any length, as far as that goes with a level horizon. */
    public static Camera along(Camera camera, Vector3dc direction) {
        return at(camera, Vectors.unit(direction), PicturePosition.MIDDLE);
    }

    /** The one of two angles that is nearer to a third; turns by 360 degrees do not count. */
    private static double nearer(double first, double second, double wanted) {
        double a = Math.IEEEremainder(first, 2 * Math.PI);
        double b = Math.IEEEremainder(second, 2 * Math.PI);
        return Math.abs(a - wanted) <= Math.abs(b - wanted) ? a : b;
    }

    /**
     * A camera whose field of view is changed by a factor, as far as it goes, while a position keeps showing the same.
     */
    public static Camera zoomed(Camera camera, double factor, PicturePosition position) {
        Vector3dc direction = position.direction(camera);
        return at(FieldOfView.zoomed(camera, factor), direction, position);
    }

    /**
     * A position of a picture.
     *
     * @param x pixels from the left edge
     * @param y pixels from the upper edge
     * @param width pixels in a row
     * @param height number of rows
     */
    public record PicturePosition(double x, double y, int width, int height) {

        /** The middle of the picture of a camera. */
        public static final PicturePosition MIDDLE = new PicturePosition(0.5, 0.5, 1, 1);

        /** The unit direction that a camera sees there; one with two eyes, at the distance of zero parallax. */
        public Vector3d direction(Camera camera) {
            PictureRays rays = new PictureRays(camera, width, height, new IdentityTransformation());
            EyeView view = rays.view(x, y);
            return new Vector3d(rays.between().chiefDirection(x - view.column(), y - view.row()));
        }

        /** Where a camera sees a unit direction, in each of its pictures that has it. */
        public static List<Vector2dc> of(Camera camera, Vector3dc direction, int width, int height) {
            return new PictureRays(camera, width, height, new IdentityTransformation()).positions(direction);
        }
    }
}
