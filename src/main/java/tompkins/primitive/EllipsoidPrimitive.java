package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;
import tompkins.surface.Surface;

/** An ellipsoid in space: a sphere of radius 1, seen in coordinates that count in semi-axes. */
public final class EllipsoidPrimitive extends Primitive {

    private final Vector3d centre;

    /** The semi-axes, as vectors in space. */
    private final Vector3d[] axes = new Vector3d[3];

    /** Their unit vectors divided by their lengths: a scalar product with them counts in semi-axes. */
    private final Vector3d first;

    private final Vector3d second;
    private final Vector3d third;

    /** Those of the sphere, in its own coordinates; null if the surface asks for none. */
    private final RoundCoordinates round;

    /**
     * An ellipsoid of an object, before it is placed.
     *
     * @param semiAxes half its lengths along x, y and z
     * @throws ArithmeticException if it is too large or too small to work with
     */
    public EllipsoidPrimitive(
            Described object, Surface surface, Vector3dc describedCentre, Vector3dc semiAxes, Placement placement) {
        super(object, surface);
        centre = placement.point(describedCentre);
        Vector3d[] inverse = new Vector3d[3];
        for (int i = 0; i < 3; i++) {
            Vector3d unit = placement.direction(new Vector3d().setComponent(i, 1));
            double length = semiAxes.get(i) * placement.scale();
            requireSquare(length);
            axes[i] = unit.mul(length, new Vector3d());
            inverse[i] = unit.div(length);
        }
        first = inverse[0];
        second = inverse[1];
        third = inverse[2];
        round = surface.usesCoordinates() ? RoundCoordinates.around(new Vector3d(0, 1, 0), Placement.NONE) : null;
    }

    private static double dot(Vector3d a, double x, double y, double z) {
        return a.x * x + a.y * y + a.z * z;
    }

    @Override
    public double distance(Ray ray, double limit) {
        double fx = centre.x - ray.x;
        double fy = centre.y - ray.y;
        double fz = centre.z - ray.z;
        double dx = dot(first, ray.dx, ray.dy, ray.dz);
        double dy = dot(second, ray.dx, ray.dy, ray.dz);
        double dz = dot(third, ray.dx, ray.dy, ray.dz);
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double inSphere = SpherePrimitive.distance(
                dot(first, fx, fy, fz),
                dot(second, fx, fy, fz),
                dot(third, fx, fy, fz),
                dx / length,
                dy / length,
                dz / length,
                1,
                ray.boundary == this,
                NO_HIT);
        double distance = inSphere / length;
        return distance <= limit ? distance : NO_HIT;
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        double x = ray.x - centre.x + distance * ray.dx;
        double y = ray.y - centre.y + distance * ray.dy;
        double z = ray.z - centre.z + distance * ray.dz;
        Vector3d onSphere = unitOrFacing(ray, dot(first, x, y, z), dot(second, x, y, z), dot(third, x, y, z));
        Vector3d normal = fromSphere(onSphere.x, onSphere.y, onSphere.z);
        Vector3d unit = unitOrFacing(ray, normal.x, normal.y, normal.z);
        Vector3d place = new Vector3d(centre)
                .fma(onSphere.x, axes[0])
                .fma(onSphere.y, axes[1])
                .fma(onSphere.z, axes[2]);
        return memory.set(
                ray, distance, place.x, place.y, place.z, unit.x, unit.y, unit.z, this, 0, coordinates(onSphere));
    }

    /** A gradient in the coordinates of the sphere, in those of space: normals change in the same way. */
    private Vector3d fromSphere(double x, double y, double z) {
        return new Vector3d(first).mul(x).fma(y, second).fma(z, third);
    }

    private SurfaceCoordinates coordinates(Vector3dc onSphere) {
        if (round == null) {
            return null;
        }
        SurfaceCoordinates at = round.onSphere(onSphere, 1);
        return new SurfaceCoordinates(
                at.u(), at.v(), fromSphere(at.uX(), at.uY(), at.uZ()), fromSphere(at.vX(), at.vY(), at.vZ()));
    }

    @Override
    protected boolean isConvex() {
        return true;
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        double x = dot(axes[0], nx, ny, nz);
        double y = dot(axes[1], nx, ny, nz);
        double z = dot(axes[2], nx, ny, nz);
        return dot(centre, nx, ny, nz) - Math.sqrt(x * x + y * y + z * z);
    }
}
