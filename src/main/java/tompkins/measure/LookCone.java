package tompkins.measure;

import java.util.List;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;

/**
 * A circle of directions: all unit vectors n with n.axis = cosine. It is the outline of a sphere, the line on which a
 * straight rod is seen, a circle of a grid of angles. Seen by a moving camera it is a circle again (Penrose 1959).
 *
 * @param axis unit vector towards the middle of the circle
 * @param cosine the cosine of its half-angle
 * @param sine the sine of its half-angle; 0 or more
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

    /** The angle between the middle and each direction of the circle, in radians, 0 to pi. */
    public double halfAngle() {
        return Math.atan2(sine, cosine);
    }

    /** The circle in a picture, as lines from point to point, in pixels. */
    List<List<Vector2dc>> lines(Projection projection) {
        return CurveTracer.lines(projection, 0, 2 * Math.PI, azimuth -> projection.position(direction(azimuth)));
    }

    /** The unit direction of the circle at an azimuth around the axis, in radians. */
    public Vector3d direction(double azimuth) {
        Vector3d first = Vectors.firstAxis(axis);
        Vector3d second = axis.cross(first, new Vector3d());
        return new Vector3d(axis)
                .mul(cosine)
                .fma(sine * Math.cos(azimuth), first)
                .fma(sine * Math.sin(azimuth), second)
                .normalize();
    }
}
