package tompkins.primitive;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.surface.Surface;

/**
 * A spherical cap, at most half a sphere: a face of a lens. It bulges to its outer side, is hollow, or is a flat disc.
 * With the place w seen from the vertex, the unit axis a and the curvature c its points have {@code c w.w + 2 a.w = 0},
 * and {@code a + c w} is the unit normal there: no radius has to grow beyond all numbers where the cap gets flat.
 */
public final class CapPrimitive extends Primitive {

    private final Vector3d edge;
    private final Vector3d vertex;
    private final Vector3d axis;
    private final double radius;
    private final double curvature;

    /** The square of a distance from the vertex that no point of the cap has. */
    private final double beyond;

    /** Null if the surface asks for no coordinates. */
    private final FaceCoordinates face;

    /**
     * A cap that is part of an object, before it is placed.
     *
     * @param edgeCentre centre of the circle at its edge
     * @param outwards direction of its axis, out of the object, of any length
     * @param radius radius of that circle
     * @param curvature the inverse of the radius of the sphere, at most that of the circle; below 0 if it is hollow
     * @throws ArithmeticException if it is too large or too small to work with
     */
    public CapPrimitive(
            Described object,
            Surface surface,
            Vector3dc edgeCentre,
            Vector3dc outwards,
            double radius,
            double curvature,
            Placement placement) {
        super(object, surface);
        Vector3d unit = Vectors.unit(outwards);
        edge = placement.point(edgeCentre);
        axis = placement.direction(unit);
        this.radius = radius * placement.scale();
        this.curvature = curvature / placement.scale();
        requireSquare(this.radius);
        double rise = placement.scale() * rise(radius, curvature);
        vertex = new Vector3d(edge).fma(rise, axis);
        beyond = WIDER * (this.radius * this.radius + rise * rise);
        double width = 2 * radius;
        face = surface.usesCoordinates() ? FaceCoordinates.across(unit, width, width, placement) : null;
    }

    /** How far the vertex of a cap lies outside the plane of its edge; below 0 if the cap is hollow. */
    public static double rise(double radius, double curvature) {
        double sine = curvature * radius;
        return sine * radius / (1 + Math.sqrt(Math.max(0, (1 - sine) * (1 + sine))));
    }

    /**
     * By the quadratic equation above. Seen from the point of the ray nearest to the vertex, far caps keep their form.
     */
    @Override
    public double distance(Ray ray, double limit) {
        boolean again = ray.boundary == this;
        double wx = ray.x - vertex.x;
        double wy = ray.y - vertex.y;
        double wz = ray.z - vertex.z;
        double along = wx * ray.dx + wy * ray.dy + wz * ray.dz;
        double slope = axis.x * ray.dx + axis.y * ray.dy + axis.z * ray.dz;
        if (again) {
            double twice = -2 * (curvature * along + slope) / curvature;
            return curvature == 0 ? NO_HIT : within(ray, twice, 0, wx, wy, wz, limit);
        }
        wx = Math.fma(-along, ray.dx, wx);
        wy = Math.fma(-along, ray.dy, wy);
        wz = Math.fma(-along, ray.dz, wz);
        double square = wx * wx + wy * wy + wz * wz;
        if (!(square <= beyond)) {
            return NO_HIT;
        }
        double constant = curvature * square + 2 * (axis.x * wx + axis.y * wy + axis.z * wz);
        double squaredCosine = slope * slope - curvature * constant;
        if (!(squaredCosine >= 0)) {
            return NO_HIT;
        }
        double q = -(slope + Math.copySign(Math.sqrt(squaredCosine), slope));
        double one = curvature == 0 ? NO_HIT : q / curvature;
        double other = q == 0 ? NO_HIT : constant / q;
        double near = within(ray, Math.min(one, other), -along, wx, wy, wz, limit);
        return near < NO_HIT ? near : within(ray, Math.max(one, other), -along, wx, wy, wz, limit);
    }

    /** {@code start + further}, if that lies in front, on the cap, and not beyond the limit; else {@link #NO_HIT}. */
    private double within(Ray ray, double further, double start, double wx, double wy, double wz, double limit) {
        double distance = start + further;
        if (!(distance > 0 && distance <= limit && distance < NO_HIT)) {
            return NO_HIT;
        }
        double x = wx + further * ray.dx;
        double y = wy + further * ray.dy;
        double z = wz + further * ray.dz;
        return holds(x, y, z, axis, radius, curvature) ? distance : NO_HIT;
    }

    /** Whether a point of the whole sphere, seen from the vertex, belongs to the cap. */
    static boolean holds(double x, double y, double z, Vector3dc axis, double radius, double curvature) {
        double height = axis.x() * x + axis.y() * y + axis.z() * z;
        double acrossX = x - height * axis.x();
        double acrossY = y - height * axis.y();
        double acrossZ = z - height * axis.z();
        return acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ <= radius * radius
                && 1 + curvature * height >= 0;
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        double x = ray.x - vertex.x + distance * ray.dx;
        double y = ray.y - vertex.y + distance * ray.dy;
        double z = ray.z - vertex.z + distance * ray.dz;
        double height = axis.x * x + axis.y * y + axis.z * z;
        double rise = 1 + curvature * height;
        x -= height * axis.x;
        y -= height * axis.y;
        z -= height * axis.z;
        double square = x * x + y * y + z * z;
        // 1 but for rounding: seen from the centre of the sphere the point is put onto it
        double length = Math.sqrt(curvature * curvature * square + rise * rise);
        double cosine = rise / length;
        x /= length;
        y /= length;
        z /= length;
        double exact = -curvature * (square / (length * length)) / (1 + cosine);
        return memory.set(
                ray,
                distance,
                vertex.x + x + exact * axis.x,
                vertex.y + y + exact * axis.y,
                vertex.z + z + exact * axis.z,
                curvature * x + cosine * axis.x,
                curvature * y + cosine * axis.y,
                curvature * z + cosine * axis.z,
                this,
                0,
                face == null ? null : face.at(x, y, z));
    }

    /** What is hollow can be met again by what leaves it. */
    @Override
    protected boolean isConvex() {
        return curvature >= 0;
    }

    @Override
    public List<Vector3d> rim() {
        return rim(edge, axis, radius);
    }

    /** That of its edge, or that of the whole sphere if the cap holds the point with it. */
    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double side = Math.copySign(length, curvature);
        double flatness = -1 / (length * Math.abs(curvature));
        double x = flatness * (nx + side * axis.x);
        double y = flatness * (ny + side * axis.y);
        double z = flatness * (nz + side * axis.z);
        return curvature != 0 && holds(x, y, z, axis, radius, curvature)
                ? nx * (vertex.x + x) + ny * (vertex.y + y) + nz * (vertex.z + z)
                : nx * edge.x + ny * edge.y + nz * edge.z - radius * lengthOfCross(nx, ny, nz, axis.x, axis.y, axis.z);
    }
}
