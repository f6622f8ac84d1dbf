package tompkins.math;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.NumberText;

/** Lengths, unit vectors and bases, safe for vectors of any length. */
public final class Vectors {

    /** A unit vector with at least this component counts as lying along that axis. */
    private static final double NEARLY_ALONG = 0.9;

    private Vectors() {}

    /**
     * The unit vector along a vector.
     *
     * @throws ArithmeticException for the zero vector and for vectors that are not finite
     */
    public static Vector3d unit(Vector3dc vector) {
        double largest = largest(vector);
        if (!(largest > 0 && largest < Double.POSITIVE_INFINITY)) {
            throw new ArithmeticException("no direction: " + vector.x() + ", " + vector.y() + ", " + vector.z());
        }
        double power = powerToUnit(largest);
        double x = vector.x() * power;
        double y = vector.y() * power;
        double z = vector.z() * power;
        double length = Math.sqrt(x * x + y * y + z * z);
        return new Vector3d(x / length, y / length, z / length);
    }

    /** The sum of two finite vectors, whose components are added as they are {@linkplain NumberText#sum written}. */
    public static Vector3d writtenSum(Vector3dc first, Vector3dc second) {
        return new Vector3d(
                NumberText.sum(first.x(), second.x()),
                NumberText.sum(first.y(), second.y()),
                NumberText.sum(first.z(), second.z()));
    }

    /** The length of a finite vector. */
    public static double length(Vector3dc vector) {
        double power = powerToUnit(largest(vector));
        double x = vector.x() * power;
        double y = vector.y() * power;
        double z = vector.z() * power;
        return Math.sqrt(x * x + y * y + z * z) / power;
    }

    private static double largest(Vector3dc vector) {
        return Math.max(Math.abs(vector.x()), Math.max(Math.abs(vector.y()), Math.abs(vector.z())));
    }

    /** A factor that brings a size to about 1; a power of two, so that it rounds nothing. */
    private static double powerToUnit(double size) {
        return Math.scalb(1.0, -Math.max(-1022, Math.min(1022, Math.getExponent(size))));
    }

    /**
     * A unit vector perpendicular to {@code normal}: the x axis laid into the plane, or the z axis where the plane
     * stands across x. A floor (normal along y) therefore has x and z as its axes.
     *
     * @param normal unit vector
     */
    public static Vector3d firstAxis(Vector3dc normal) {
        return laidInto(normal, Math.abs(normal.x()) < NEARLY_ALONG ? new Vector3d(1, 0, 0) : new Vector3d(0, 0, 1));
    }

    /**
     * The direction on a face that is up for somebody who looks at it from outside: the y axis laid into the face, or,
     * if the face is level, z if it is seen from above and -z if it is seen from below. Right is then normal x up,
     * because x points to the right, y up and z away from the viewer.
     *
     * @param normal unit vector out of the face
     */
    public static Vector3d upOnFace(Vector3dc normal) {
        return laidInto(
                normal,
                Math.abs(normal.y()) < NEARLY_ALONG
                        ? new Vector3d(0, 1, 0)
                        : new Vector3d(0, 0, Math.signum(normal.y())));
    }

    /**
     * The side of an object around an axis on which to show the middle of a picture: that of -z, where a camera at the
     * origin stands, or that of y where the axis itself runs along z.
     *
     * @param axis unit vector
     * @return a unit vector perpendicular to the axis
     */
    public static Vector3d middleAround(Vector3dc axis) {
        return laidInto(axis, Math.abs(axis.z()) < NEARLY_ALONG ? new Vector3d(0, 0, -1) : new Vector3d(0, 1, 0));
    }

    private static Vector3d laidInto(Vector3dc normal, Vector3d axis) {
        double along = axis.dot(normal);
        return unit(axis.sub(normal.x() * along, normal.y() * along, normal.z() * along));
    }

    /**
     * The unit vector perpendicular to {@code normal} and {@code first} whose largest component is positive.
     *
     * @param normal unit vector
     * @param first unit vector perpendicular to the normal
     */
    public static Vector3d secondAxis(Vector3dc normal, Vector3dc first) {
        Vector3d axis = normal.cross(first, new Vector3d());
        double largest = axis.get(axis.maxComponent());
        // adding 0 turns -0 into 0
        return (largest < 0 ? axis.negate() : axis).add(0, 0, 0);
    }

    /** The cross product with each component right to 2 u, also for vectors that are nearly parallel. */
    public static Vector3d cross(Vector3dc a, Vector3dc b) {
        return new Vector3d(
                Precise.differenceOfProducts(a.y(), b.z(), a.z(), b.y()),
                Precise.differenceOfProducts(a.z(), b.x(), a.x(), b.z()),
                Precise.differenceOfProducts(a.x(), b.y(), a.y(), b.x()));
    }
}
