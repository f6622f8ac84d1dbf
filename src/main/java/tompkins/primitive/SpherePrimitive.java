package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.ray.SurfaceCoordinates;
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

    /**
     * By the distance of the centre from the line, which does not cancel for far or huge spheres, where the
     * discriminant {@code b^2 - c} of the quadratic equation loses all digits. A ray that starts on the sphere meets it
     * again only at the other end of its chord.
     */
    @Override
    public double distance(Ray ray, double limit) {
        double fx = x - ray.x;
        double fy = y - ray.y;
        double fz = z - ray.z;
        double along = fx * ray.dx + fy * ray.dy + fz * ray.dz;
        if (ray.boundary == this) {
            return nearest(2 * along, 0, limit);
        }
        double lx = fx - along * ray.dx;
        double ly = fy - along * ray.dy;
        double lz = fz - along * ray.dz;
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
    public boolean missMargins(RayPacket rays, RayStarts starts, double[] margins) {
        return ballMissMargins(x, y, z, radius, rays, starts, margins);
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        double nx = ray.x - x + distance * ray.dx;
        double ny = ray.y - y + distance * ray.dy;
        double nz = ray.z - z + distance * ray.dz;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (hasSquare(length)) {
            nx /= length;
            ny /= length;
            nz /= length;
        } else {
            Vector3d normal = unitOrFacing(ray, nx, ny, nz);
            nx = normal.x;
            ny = normal.y;
            nz = normal.z;
        }
        SurfaceCoordinates coordinates = round == null ? null : coordinates(new Vector3d(nx, ny, nz));
        return memory.set(
                ray, distance, x + radius * nx, y + radius * ny, z + radius * nz, nx, ny, nz, this, 0, coordinates);
    }

    private SurfaceCoordinates coordinates(Vector3dc normal) {
        double toRight = normal.dot(round.right());
        double toMiddle = normal.dot(round.middle());
        double height = normal.dot(round.axis());
        double level = Math.hypot(toRight, toMiddle);
        double u = Math.atan2(toRight, toMiddle) / (2 * Math.PI) + 0.5;
        double v = Math.atan2(height, level) / Math.PI + 0.5;
        double perTurn = 1 / (2 * Math.PI * radius * Math.max(level, 1e-12));
        double perHalfTurn = 1 / (Math.PI * radius);
        Vector3d alongU = level == 0
                ? new Vector3d(round.right())
                : new Vector3d(round.right())
                        .mul(toMiddle / level)
                        .sub(new Vector3d(round.middle()).mul(toRight / level));
        // at a pole all directions are level: the limit from in front is used
        Vector3d alongV = level == 0
                ? new Vector3d(round.middle()).mul(-height)
                : new Vector3d(round.axis())
                        .sub(new Vector3d(normal).mul(height))
                        .div(level);
        return new SurfaceCoordinates(
                u,
                v,
                alongU.x * perTurn,
                alongU.y * perTurn,
                alongU.z * perTurn,
                alongV.x * perHalfTurn,
                alongV.y * perHalfTurn,
                alongV.z * perHalfTurn);
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        return nx * x + ny * y + nz * z - radius * Math.sqrt(nx * nx + ny * ny + nz * nz);
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(new Vector3d(x, y, z), radius, radius, radius);
    }
}
