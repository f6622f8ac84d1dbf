package optics;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import tompkins.math.Vectors;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;

/** A torus, placed: a line meets it where a polynomial of the fourth degree is 0. */
final class TorusShape extends Primitive {

    private static final int HALVINGS = 60;

    private final boolean hasCoordinates;
    private final Vector3d centre;
    private final Vector3d axis;
    private final double ring;
    private final double tube;

    TorusShape(Torus torus, Placement placement) {
        super(torus, torus.surface());
        hasCoordinates = torus.surface().usesCoordinates();
        centre = placement.point(torus.centre());
        axis = placement.direction(torus.axis()).normalize();
        ring = torus.radius() * placement.scale();
        tube = torus.tubeRadius() * placement.scale();
    }

    /** Distances are counted from where the line is nearest to the centre, so that far rays keep their digits. */
    @Override
    public double distance(Ray ray, double limit) {
        Vector3d direction = new Vector3d(ray.dx, ray.dy, ray.dz);
        Vector3d place = new Vector3d(ray.x, ray.y, ray.z).sub(centre);
        double start = direction.dot(place);
        place.fma(-start, direction);
        double square = place.lengthSquared();
        // a little more than it reaches
        double reach = 1.01 * (ring + tube);
        if (square > reach * reach) {
            return NO_HIT;
        }
        double along = axis.dot(direction);
        double height = axis.dot(place);
        double rest = square + ring * ring - tube * tube;
        double four = 4 * ring * ring;
        double[] torus = {
            rest * rest - four * (square - height * height),
            2 * four * height * along,
            2 * rest - four * (1 - along * along),
            0,
            1
        };
        // where the ray starts on the torus, that root is divided out
        boolean again = ray.boundary == this;
        for (double root :
                roots(again ? divided(torus, start) : torus, again ? start : Math.max(start, -reach), reach)) {
            if (root > start && root - start <= limit) {
                return root - start;
            }
        }
        return NO_HIT;
    }

    private static double[] divided(double[] polynomial, double root) {
        double[] quotient = new double[polynomial.length - 1];
        double carried = 0;
        for (int i = quotient.length; i > 0; i--) {
            carried = carried * root + polynomial[i];
            quotient[i - 1] = carried;
        }
        return quotient;
    }

    /** The roots between two places, rising: one between any two roots of the derivative where the sign changes. */
    private static List<Double> roots(double[] polynomial, double from, double to) {
        List<Double> roots = new ArrayList<>();
        List<Double> ends = new ArrayList<>();
        if (polynomial.length > 2) {
            double[] derivative = new double[polynomial.length - 1];
            for (int i = 0; i < derivative.length; i++) {
                derivative[i] = (i + 1) * polynomial[i + 1];
            }
            ends.addAll(roots(derivative, from, to));
        }
        ends.add(to);
        double low = from;
        for (double high : ends) {
            if (value(polynomial, low) > 0 != value(polynomial, high) > 0) {
                roots.add(root(polynomial, low, high));
            }
            low = high;
        }
        return roots;
    }

    private static double root(double[] polynomial, double from, double to) {
        double low = from;
        double high = to;
        boolean rises = value(polynomial, high) > 0;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (low + high) / 2;
            if (value(polynomial, middle) > 0 == rises) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return (low + high) / 2;
    }

    private static double value(double[] polynomial, double x) {
        double value = 0;
        for (int i = polynomial.length - 1; i >= 0; i--) {
            value = value * x + polynomial[i];
        }
        return value;
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        Vector3d place = new Vector3d(ray.dx, ray.dy, ray.dz)
                .mul(distance)
                .add(ray.x, ray.y, ray.z)
                .sub(centre);
        Vector3d outwards = new Vector3d(axis).mul(-axis.dot(place)).add(place).normalize();
        Vector3d normal = new Vector3d(outwards).mul(-ring).add(place).normalize();
        SurfaceCoordinates coordinates = hasCoordinates ? coordinates(outwards, normal) : null;
        return memory.set(ray, distance, normal.x, normal.y, normal.z, this, 0, coordinates);
    }

    /** Coordinates with their gradients: 1/(2 pi) over the distance from the axis, and over that from the ring. */
    private SurfaceCoordinates coordinates(Vector3d outwards, Vector3d normal) {
        Vector3d first = Vectors.firstAxis(axis);
        Vector3d around = axis.cross(outwards, new Vector3d());
        double turn = Math.atan2(outwards.dot(axis.cross(first, new Vector3d())), outwards.dot(first));
        double rise = Math.atan2(normal.dot(axis), normal.dot(outwards));
        Vector3d gradientU = around.mul(1 / (2 * Math.PI * (ring + tube * Math.cos(rise))), new Vector3d());
        Vector3d gradientV = normal.cross(around.normalize(), new Vector3d()).mul(1 / (2 * Math.PI * tube));
        return new SurfaceCoordinates(
                turn / (2 * Math.PI) + 0.5,
                rise / (2 * Math.PI) + 0.5,
                gradientU.x,
                gradientU.y,
                gradientU.z,
                gradientV.x,
                gradientV.y,
                gradientV.z);
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        Vector3d normal = new Vector3d(nx, ny, nz);
        return normal.dot(centre) - ring * axis.cross(normal, new Vector3d()).length() - tube * normal.length();
    }
}
