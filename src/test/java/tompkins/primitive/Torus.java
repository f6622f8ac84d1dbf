package tompkins.primitive;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;
import tompkins.surface.Surface;

/** A torus: all points at one distance from a circle. A line meets it up to four times. */
public final class Torus extends Primitive {

    private final Vector3dc centre;
    private final Vector3dc axis;
    private final double radius;
    private final double tube;
    private final RoundCoordinates round;

    /**
     * A torus of an object, before it is placed.
     *
     * @param axis of any length
     * @param radius that of the circle
     * @param tube that of the tube around it, smaller
     */
    public Torus(
            Described object,
            Surface surface,
            Vector3dc centre,
            Vector3dc axis,
            double radius,
            double tube,
            Placement placement) {
        super(object, surface);
        this.centre = placement.point(centre);
        this.axis = placement.direction(Vectors.unit(axis));
        this.radius = radius * placement.scale();
        this.tube = tube * placement.scale();
        round = surface.usesCoordinates() ? RoundCoordinates.around(axis, placement) : null;
    }

    /**
     * By the roots of a quartic equation in the distance from the place on the line that is nearest to the centre,
     * where lengths are in units of the radius. A ray that starts here has one of them behind it: that is divided out.
     */
    @Override
    public double distance(Ray ray, double limit) {
        Vector3d from = new Vector3d(ray.x, ray.y, ray.z).sub(centre).div(radius);
        double middle = -from.dot(ray.dx, ray.dy, ray.dz);
        from.add(middle * ray.dx, middle * ray.dy, middle * ray.dz);
        double square = from.lengthSquared();
        double thickness = tube / radius;
        double half = Math.sqrt((1 + thickness) * (1 + thickness) - square); // NaN, and no roots, if it passes by
        // with |p|^2 = square + s^2 and p.axis = height + s rise: (|p|^2 + 1 - thickness^2)^2 = 4 (|p|^2 - (p.axis)^2)
        double height = from.dot(axis);
        double rise = axis.dot(ray.dx, ray.dy, ray.dz);
        double sum = square + 1 - thickness * thickness;
        double bend = 2 * sum - 4 * (1 - rise * rise);
        double[] terms = {sum * sum - 4 * (square - height * height), 8 * height * rise, bend, 0, 1};
        for (double root : roots(ray.boundary == this ? without(-middle, terms) : terms, -half, half)) {
            double distance = (root + middle) * radius;
            if (distance > 0 && distance <= limit) {
                return distance;
            }
        }
        return NO_HIT;
    }

    /** A polynomial, divided by {@code s - root}; terms begin with the constant. */
    private static double[] without(double root, double[] terms) {
        double[] quotient = Arrays.copyOfRange(terms, 1, terms.length);
        for (int i = quotient.length - 2; i >= 0; i--) {
            quotient[i] += root * quotient[i + 1];
        }
        return quotient;
    }

    /** The roots between two places, in order: between those of the derivative there is one where the sign changes. */
    private static double[] roots(double[] terms, double from, double to) {
        double[] slope = new double[terms.length - 1];
        Arrays.setAll(slope, i -> (i + 1) * terms[i + 1]);
        double[] turns = slope.length == 1 ? new double[0] : roots(slope, from, to);
        DoubleStream.Builder found = DoubleStream.builder();
        for (int i = 0; i <= turns.length; i++) {
            double low = i == 0 ? from : turns[i - 1];
            double high = i == turns.length ? to : turns[i];
            if (value(terms, low) > 0 != value(terms, high) > 0) {
                found.add(root(terms, slope, low, high));
            }
        }
        return found.build().toArray();
    }

    /** The root between two places with different signs, by Newton's method, or by halving where that leaves them. */
    private static double root(double[] terms, double[] slope, double from, double to) {
        boolean endsAbove = value(terms, to) > 0;
        double low = from;
        double high = to;
        double at = (low + high) / 2;
        double before = Double.NaN;
        while (at != before && low < at && at < high) {
            before = at;
            double value = value(terms, at);
            low = value > 0 == endsAbove ? low : at;
            high = value > 0 == endsAbove ? at : high;
            double next = at - value / value(slope, at);
            at = low <= next && next <= high ? next : (low + high) / 2;
        }
        return at;
    }

    private static double value(double[] terms, double at) {
        double value = 0;
        for (int i = terms.length - 1; i >= 0; i--) {
            value = value * at + terms[i];
        }
        return value;
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        Vector3d at = new Vector3d(ray.dx, ray.dy, ray.dz).mul(distance).add(ray.x, ray.y, ray.z);
        Vector3d out = at.sub(centre, new Vector3d());
        Vector3d radial = Vectors.unit(out.fma(-out.dot(axis), axis));
        Vector3d normal = at.sub(centre).fma(-radius, radial).normalize();
        SurfaceCoordinates coordinates = round == null ? null : coordinates(radial, normal);
        return memory.set(ray, distance, normal.x, normal.y, normal.z, this, 0, coordinates);
    }

    /** Here u runs once around the axis, and v around the tube, upwards outside, where it is 1/2. */
    private SurfaceCoordinates coordinates(Vector3dc radial, Vector3dc normal) {
        double outwards = normal.dot(radial);
        double upwards = normal.dot(axis);
        double v = Math.atan2(upwards, outwards) / (2 * Math.PI) + 0.5;
        SurfaceCoordinates at = round.at(radial, radius + tube * outwards, v, 1);
        Vector3d up = axis.mul(outwards, new Vector3d()).fma(-upwards, radial).div(2 * Math.PI * tube);
        return at.withGradients(new Vector3d(at.uX(), at.uY(), at.uZ()), up);
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        return centre.dot(nx, ny, nz)
                - radius * lengthOfCross(nx, ny, nz, axis.x(), axis.y(), axis.z())
                - tube * length;
    }
}
