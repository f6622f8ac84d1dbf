package tompkins.spacetime;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;

/**
 * A moment of a worldline: where and when a rider is in the scene frame, and how fast. Thrust leads from one moment to
 * the next, exactly: with the proper acceleration a (what an accelerometer on board shows) and the time s on board, the
 * rider moves in the frame in which it was at rest by {@code (cosh(a s) - 1)/a} in the time {@code sinh(a s)/a}, and
 * its velocity there is then {@code tanh(a s)} (hyperbolic motion).
 *
 * <p>Directions on board are given in the axes of the camera frame, which is a pure boost of the scene frame. What does
 * not turn on board (a gyroscope) turns against these axes when the thrust is not along the motion, because two boosts
 * are a boost and a rotation (Thomas and Wigner); a step says by how much.
 *
 * @param event where and when, in the scene frame
 * @param proper the proper velocity u = gamma beta in the scene frame
 */
public record Rider(Event event, Vector3dc proper) {

    /** The speed that rounding leaves after braking, divided by the square of gamma. */
    private static final double ROUNDING = 2e-15;

    /** Keeps a copy, which nobody else can change. */
    public Rider {
        proper = new Vector3d(proper);
    }

    /** A rider at an event with a velocity. */
    public Rider(Event event, Velocity velocity) {
        this(event, velocity.proper());
    }

    /**
     * A later moment.
     *
     * @param rider the rider then
     * @param turn how axes that do not turn on board have turned against those of the camera frame, by components
     */
    public record Step(Rider rider, Quaterniondc turn) {}

    /** The Lorentz factor. */
    public double gamma() {
        return ProperVelocity.of(proper).gamma();
    }

    /** The rapidity. */
    public double rapidity() {
        return velocity().rapidity();
    }

    /** The velocity in the scene frame. */
    public Velocity velocity() {
        return Velocity.ofProper(proper);
    }

    /**
     * The moment after constant thrust.
     *
     * @param acceleration proper acceleration in the axes of the camera frame at the beginning; constant on board
     * @param time how long, by a clock on board
     */
    public Step after(Vector3dc acceleration, double time) {
        double strength = Vectors.length(acceleration);
        if (strength * time == 0) {
            return new Step(new Rider(later(new Event(0, 0, 0, time)), proper), new Quaterniond());
        }
        Vector3d along = Vectors.unit(acceleration);
        double rapidity = strength * time;
        double half = Math.sinh(rapidity / 2);
        Vector3d way = along.mul(2 * half * half / strength, new Vector3d());
        Event moved = later(new Event(way.x, way.y, way.z, Math.sinh(rapidity) / strength));
        ProperVelocity before = ProperVelocity.of(proper);
        ProperVelocity gained = new ProperVelocity(along.mul(Math.sinh(rapidity), new Vector3d()), Math.cosh(rapidity));
        Vector3dc sum = before.plus(gained).proper();
        // thrust against the motion leaves a difference of large numbers
        boolean stopped = sum.length() < ROUNDING * gained.gamma() * gained.gamma();
        // the axes that come from two boosts, seen from those of the one boost that leads to the same velocity
        return new Step(
                new Rider(moved, stopped ? new Vector3d() : sum),
                before.rotation(gained).conjugate());
    }

    /** The thrust against the motion, which leads to rest in the time rapidity/strength on board; none at rest. */
    public Vector3d brake(double strength) {
        return proper.lengthSquared() == 0
                ? new Vector3d()
                : Vectors.unit(proper).mul(-strength);
    }

    /** An event in the rest frame, counted from the present one, in the scene frame. */
    private Event later(Event own) {
        Vector3d place = own.position();
        double along = proper.dot(place);
        double factor = along / (gamma() + 1) + own.time();
        return new Event(
                event.x() + (own.x() + proper.x() * factor),
                event.y() + (own.y() + proper.y() * factor),
                event.z() + (own.z() + proper.z() * factor),
                event.time() + (gamma() * own.time() + along));
    }
}
