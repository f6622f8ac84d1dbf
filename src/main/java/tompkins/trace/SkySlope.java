package tompkins.trace;

import org.joml.Vector3d;
import tompkins.ray.Ray;
import tompkins.trace.NearbyRays.Leaving;

/** How directions in the sky change with the place in the picture, past mirrors and glass. Used again. */
final class SkySlope {

    /** Distance of the neighbours in pixels: so near that the slope is that of the place. */
    private static final double STEP = 1e-4;

    /** At a caustic, where a whole area shows one point of the sky, its light grows by so much and no more. */
    private static final double LARGEST = 1e6;

    private final Ray ray = Ray.blank();

    // the rays of neighbours, which all ways from one place share
    private final Leaving toRight = new Leaving();
    private final Leaving toLeft = new Leaving();
    private final Leaving below = new Leaving();
    private final Leaving above = new Leaving();

    private final Vector3d right = new Vector3d();
    private final Vector3d down = new Vector3d();
    private final Vector3d lookRight = new Vector3d();
    private final Vector3d lookDown = new Vector3d();
    private final Vector3d across = new Vector3d();
    private double x;
    private double y;
    private double magnification;

    // the way from a direction to another one, in pixels
    private double stepX;
    private double stepY;

    /**
     * Measures the slope at a place.
     *
     * @param here the rays of the place
     * @param central one of them
     * @param way its way
     * @return whether neighbours to the side, and above or below, have taken the same way
     */
    boolean measure(NearbyRays rays, double newX, double newY, Leaving here, Ray central, long way) {
        x = newX;
        y = newY;
        ray.set(central);
        if (!(measure(rays, STEP, 0, here, way, toRight, right, lookRight)
                        || measure(rays, -STEP, 0, here, way, toLeft, right, lookRight))
                || !(measure(rays, 0, STEP, here, way, below, down, lookDown)
                        || measure(rays, 0, -STEP, here, way, above, down, lookDown))) {
            return false;
        }
        double area = right.cross(down, across).length();
        double lookArea = lookRight.cross(lookDown, across).length();
        magnification = Math.min(LARGEST, lookArea / area);
        return area > 0;
    }

    private boolean measure(
            NearbyRays rays,
            double byX,
            double byY,
            Leaving here,
            long way,
            Leaving memory,
            Vector3d change,
            Vector3d lookChange) {
        Ray aside = rays.at(x + byX, y + byY, memory).onWay(way, ray);
        if (aside == null) {
            return false;
        }
        double step = byX + byY;
        change.set(aside.dx - ray.dx, aside.dy - ray.dy, aside.dz - ray.dz).div(step);
        memory.look.sub(here.look, lookChange).div(step);
        return true;
    }

    /** Goes from a ray to a direction, a unit vector: the step in pixels, as if the slope were the same everywhere. */
    void aim(Ray from, double toX, double toY, double toZ) {
        across.set(toX - from.dx, toY - from.dy, toZ - from.dz);
        double alongRight = across.dot(right);
        double alongDown = across.dot(down);
        double mixed = right.dot(down);
        double determinant = right.lengthSquared() * down.lengthSquared() - mixed * mixed;
        stepX = (down.lengthSquared() * alongRight - mixed * alongDown) / determinant;
        stepY = (right.lengthSquared() * alongDown - mixed * alongRight) / determinant;
    }

    /** The ray of the place. */
    Ray ray() {
        return ray;
    }

    /** The place in pixels. */
    double x() {
        return x;
    }

    double y() {
        return y;
    }

    /** The step of the last aim in pixels. */
    double stepX() {
        return stepX;
    }

    double stepY() {
        return stepY;
    }

    /** A small solid angle in the picture divided by that which it shows of the sky. */
    double magnification() {
        return magnification;
    }

    /** The largest angle in the sky that a step of a pixel can make, in radians, or a little more. */
    double steepest() {
        return Math.sqrt(right.lengthSquared() + down.lengthSquared());
    }
}
