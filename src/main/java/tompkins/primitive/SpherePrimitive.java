package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.surface.Surface;

/** A sphere in space. */
public final class SpherePrimitive extends Primitive {

    private final double x;
    private final double y;
    private final double z;
    private final double radius;

    /** Null if the surface asks for no coordinates. */
    private final RoundCoordinates round;

    /** A sphere of an object, before it is placed. */
    public SpherePrimitive(
            Described object, Surface surface, Vector3dc describedCentre, double radius, Placement placement) {
        super(object, surface);
        Vector3d centre = placement.point(describedCentre);
        x = centre.x;
        y = centre.y;
        z = centre.z;
        this.radius = radius * placement.scale();
        round = surface.usesCoordinates() ? RoundCoordinates.around(new Vector3d(0, 1, 0), placement) : null;
    }

    /** The centre, after the placement. */
    public Vector3d centre() {
        return new Vector3d(x, y, z);
    }

    /** The radius, after the placement. */
    public double radius() {
        return radius;
    }

    @Override
    public double distance(Ray ray, double limit) {
        return distance(x - ray.x, y - ray.y, z - ray.z, ray.dx, ray.dy, ray.dz, radius, ray.boundary == this, limit);
    }

    /**
     * By the distance of the centre from the line, which does not cancel for far or huge spheres, where the
     * discriminant {@code b^2 - c} of the quadratic equation loses all digits. A ray that starts on the sphere meets it
     * again only at the other end of its chord.
     *
     * @param fx x coordinate of the centre, seen from the start of the ray; fy and fz are the others
     * @param dx x component of the unit direction of the ray; dy and dz are the others
     * @param again whether the ray starts on the sphere
     */
    static double distance(
            double fx,
            double fy,
            double fz,
            double dx,
            double dy,
            double dz,
            double radius,
            boolean again,
            double limit) {
        double along = fx * dx + fy * dy + fz * dz;
        if (again) {
            return nearest(2 * along, 0, limit);
        }
        double lx = fx - along * dx;
        double ly = fy - along * dy;
        double lz = fz - along * dz;
        double offset = Math.sqrt(lx * lx + ly * ly + lz * lz);
        if (offset > radius) {
            return NO_HIT;
        }
        // the radius is not squared, so that a sky may have any radius that a number can hold
        double halfChord = Math.sqrt(radius - offset) * Math.sqrt(radius + offset);
        double centreDistance = Math.sqrt(fx * fx + fy * fy + fz * fz);
        double height = centreDistance - radius;
        double reach = centreDistance + radius;
        if (along > 0) {
            double far = along + halfChord;
            return nearest(height * (reach / far), far, limit);
        }
        // the centre lies behind: only a ray from inside meets the sphere
        double near = along - halfChord;
        return near < 0 ? nearest(height * (reach / near), 0, limit) : NO_HIT;
    }

    @Override
    public boolean overlaps(RayPacket rays, boolean oneStart, double farthest, double[] overlaps) {
        return ballOverlaps(x, y, z, radius, rays, oneStart, farthest, overlaps);
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        Vector3d normal = unitOrFacing(
                ray, ray.x - x + distance * ray.dx, ray.y - y + distance * ray.dy, ray.z - z + distance * ray.dz);
        return memory.set(
                ray,
                distance,
                x + radius * normal.x,
                y + radius * normal.y,
                z + radius * normal.z,
                normal.x,
                normal.y,
                normal.z,
                this,
                0,
                round == null ? null : round.onSphere(normal, radius));
    }

    @Override
    protected boolean isConvex() {
        return true;
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        return nx * x + ny * y + nz * z - radius * Math.sqrt(nx * nx + ny * ny + nz * nz);
    }
}
