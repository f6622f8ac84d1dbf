package tompkins.measure;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.spacetime.Velocity;

/**
 * A circle of directions: all unit vectors n with n.axis = cosine. It is the outline of a sphere, the line on which a
 * straight rod is seen, a circle of a grid of angles. Seen by a moving camera it is a circle again (Penrose 1959): with
 * u = gamma beta,
 *
 * <pre>axis' = axis + u ((u.axis)/(gamma + 1) + cosine),   cosine' = gamma cosine + u.axis</pre>
 *
 * (axis, cosine) changes as the place and the time of an event do, so that sine² = |axis|² - cosine² stays.
 *
 * @param axis towards the middle of the circle, of any length
 * @param cosine the cosine of its half-angle, times the length of the axis
 * @param sine the sine of its half-angle, times the length of the axis; 0 or more
 */
public record LookCone(Vector3dc axis, double cosine, double sine) {

    /** The circle around a direction of any length, at an angle in radians, 0 to pi. */
    public static LookCone around(Vector3dc direction, double halfAngle) {
        return new LookCone(Vectors.unit(direction), Math.cos(halfAngle), Math.sin(halfAngle));
    }

    /** The great circle across a direction of any length. */
    public static LookCone across(Vector3dc direction) {
        return new LookCone(Vectors.unit(direction), 0, 1);
    }

    /** The outline of a sphere at rest, seen from a point; null if the point lies in it. */
    public static LookCone outline(Vector3dc from, Vector3dc centre, double radius) {
        Vector3d towards = centre.sub(from, new Vector3d());
        double distance = towards.length();
        if (!(distance > radius)) {
            return null;
        }
        double sine = radius / distance;
        return new LookCone(towards.div(distance), Math.sqrt((1 - sine) * (1 + sine)), sine);
    }

    /**
     * The great circle on which a straight line at rest is seen (Boas 1961); null if the point lies on it.
     *
     * @param through a point of the line
     * @param along its direction
     */
    public static LookCone line(Vector3dc from, Vector3dc through, Vector3dc along) {
        Vector3d across = Vectors.cross(through.sub(from, new Vector3d()), along);
        return across.lengthSquared() > 0 ? across(across) : null;
    }

    /** The same circle, seen by a camera that moves with a velocity. */
    public LookCone seenBy(Velocity velocity) {
        Vector3dc u = velocity.proper();
        double along = u.dot(axis);
        return new LookCone(
                new Vector3d(axis).fma(along / (velocity.gamma() + 1) + cosine, u),
                velocity.gamma() * cosine + along,
                sine);
    }

    /** The angle between the middle and each direction of the circle, in radians, 0 to pi. */
    public double halfAngle() {
        return Math.atan2(sine, cosine);
    }

    /** Whether it is a great circle, which a lens shows as a straight line. */
    public boolean isStraight() {
        return Math.abs(cosine) <= 1e-12 * sine;
    }

    /** The unit direction of the circle at an azimuth around the axis, in radians. */
    public Vector3d direction(double azimuth) {
        double length = axis.length();
        Vector3d middle = Vectors.unit(axis);
        Vector3d first = Vectors.firstAxis(middle);
        Vector3d second = middle.cross(first, new Vector3d());
        return middle.mul(cosine / length)
                .fma(sine / length * Math.cos(azimuth), first)
                .fma(sine / length * Math.sin(azimuth), second)
                .normalize();
    }
}
