package tompkins.surface;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Medium;
import tompkins.ray.Ray;

/**
 * The wave of a ray in a medium, in the frame of a boundary through which the medium moves. A boundary keeps the
 * frequency of the wave in its rest frame, and the part of the wave vector along itself; ray and wave have different
 * directions there.
 *
 * <p>With the four-velocity V of the medium, the tangent T of the ray and the wave four-vector W belong together by
 * {@code W = n T + (1 - 1/n^2) n (T.V) V} and {@code T = W/n - (n - 1/n) (W.V) V} (signs + + + -), and W satisfies
 * {@code W.W = (n^2 - 1) (W.V)^2}. In the rest frame of the medium that is T = (d, -n |d|), W = (n d, -|d|).
 *
 * @param vector the wave vector, for the frequency 1
 * @param frequency that of the wave if the tangent of its ray has the length 1
 */
record MediumWave(Vector3dc vector, double frequency) {

    /**
     * The wave of a ray.
     *
     * @param tracer knows how the medium moves
     */
    static MediumWave of(Ray ray, Tracer tracer) {
        Vector3d direction = new Vector3d(ray.dx, ray.dy, ray.dz);
        Medium medium = ray.medium;
        if (!moves(medium, ray.frame)) {
            return new MediumWave(direction.mul(medium == null ? 1 : medium.index()), 1);
        }
        Vector3dc proper = tracer.velocity(medium, ray.frame);
        double gamma = gamma(proper);
        double index = medium.index();
        double drag = index - 1 / index;
        double along = direction.dot(proper) + ray.slowness * gamma;
        double frequency = index * ray.slowness - drag * along * gamma;
        return new MediumWave(direction.mul(index).fma(drag * along, proper).div(frequency), frequency);
    }

    /** Whether a medium moves in a frame; vacuum does not. */
    static boolean moves(Medium medium, int frame) {
        return medium != null && medium.frame() != frame;
    }

    private static double gamma(Vector3dc proper) {
        return Math.sqrt(1 + proper.lengthSquared());
    }

    /** Whether the boundary meets the wave, instead of running away from it faster than it follows. */
    boolean isMet() {
        return frequency > 0;
    }

    /** The unit vector along the wave vector. */
    Vector3d direction() {
        return vector.normalize(new Vector3d());
    }

    /** How often the wave is shorter than one of the same frequency in vacuum: the index for this direction. */
    double index() {
        return vector.length();
    }

    /**
     * A wave that leaves a boundary, and its ray.
     *
     * @param vector the wave vector
     * @param direction unit vector along the ray
     * @param slowness that of the ray
     * @param length length of the tangent of the ray, if that of the ray that has come has the length 1
     */
    record Outgoing(Vector3dc vector, Vector3dc direction, double slowness, double length) {

        /** The index for the direction of the wave. */
        double index() {
            return vector.length();
        }

        /** The ray that goes on from a hit, with a fraction of the light of the one that has hit. */
        Ray ray(Ray before, Hit hit, double fraction) {
            return before.bent(hit, direction.x(), direction.y(), direction.z(), fraction)
                    .slowed(slowness)
                    .stretched(length);
        }
    }

    /**
     * The wave of the same frequency, with the same part along a boundary, in a medium; null if there is none.
     *
     * @param normal unit normal of the boundary
     * @param side 1 for the ray that goes to the side of the normal, -1 for the other side
     * @param frame the number of the frame of the boundary
     * @param tracer knows how the medium moves
     */
    Outgoing outgoing(Vector3dc normal, double side, Medium medium, int frame, Tracer tracer) {
        double index = medium == null ? 1 : medium.index();
        Vector3dc proper = moves(medium, frame) ? tracer.velocity(medium, frame) : new Vector3d();
        Vector3d alongBoundary = vector.fma(-vector.dot(normal), normal, new Vector3d());
        double gamma = gamma(proper);
        double excess = (index - 1) * (index + 1);
        double normalSpeed = normal.dot(proper);
        double seen = alongBoundary.dot(proper) + gamma;
        double a = 1 - excess * normalSpeed * normalSpeed;
        double b = -excess * normalSpeed * seen;
        double c = alongBoundary.lengthSquared() - 1 - excess * seen * seen;
        double root = Math.sqrt(b * b - a * c);
        Vector3d wave = alongBoundary.fma((side * root - b) / a, normal);
        // the frequency in the rest frame of the medium
        double own = wave.dot(proper) + gamma;
        if (!(own > 0)) {
            return null;
        }
        double drag = (index - 1 / index) * own;
        Vector3d tangent = new Vector3d(wave).div(index).fma(-drag, proper);
        double length = tangent.length();
        return new Outgoing(wave, tangent.div(length), (1 / index + drag * gamma) / length, frequency * length);
    }
}
