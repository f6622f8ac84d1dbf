package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.ray.SurfaceCoordinates;
import tompkins.surface.Surface;

/** An infinite plane in space. */
public final class PlanePrimitive extends Primitive {

    private final Vector3d point;
    private final Vector3d normal;
    private final Vector3d first;
    private final Vector3d second;
    private final double scale;

    /** The plane of an object through a point, with a normal of any length, before it is placed. */
    public PlanePrimitive(
            Described object,
            Surface surface,
            Vector3dc describedPoint,
            Vector3dc describedNormal,
            Placement placement) {
        super(object, surface);
        Vector3d unit = Vectors.unit(describedNormal);
        Vector3d axis = Vectors.firstAxis(unit);
        point = placement.point(describedPoint);
        normal = placement.direction(unit);
        first = placement.direction(axis);
        second = placement.direction(Vectors.secondAxis(unit, axis));
        scale = 1 / placement.scale();
    }

    @Override
    public double distance(Ray ray, double limit) {
        if (ray.boundary == this) {
            return NO_HIT;
        }
        double height = heightBelow(ray.x, ray.y, ray.z);
        double slope = slope(ray.dx, ray.dy, ray.dz);
        // most rays that miss are found without a division
        if (height > 0 != slope > 0) {
            return NO_HIT;
        }
        double distance = height / slope;
        return distance > 0 && distance <= limit ? distance : NO_HIT;
    }

    /** By the same signs as {@link #distance}. */
    @Override
    public boolean overlaps(RayPacket rays, boolean oneStart, double farthest, double[] overlaps) {
        if (!hasSquare(farthest + Math.abs(point.x) + Math.abs(point.y) + Math.abs(point.z))) {
            return false;
        }
        int count = rays.count();
        for (int i = 0; i < count; i++) {
            overlaps[i] = slope(rays.dx[i], rays.dy[i], rays.dz[i]);
        }
        for (int i = 0; i < count; i++) {
            overlaps[i] *= heightBelow(rays.x[i], rays.y[i], rays.z[i]);
        }
        return true;
    }

    /** Also of rays that start beside it. */
    @Override
    public boolean leavesConvexShape(Hit from, double dx, double dy, double dz) {
        return from.boundary == this || heightBelow(from.x, from.y, from.z) * slope(dx, dy, dz) < 0;
    }

    /** The normal times (point - start), subtracted first so that no digits are lost near the plane. */
    private double heightBelow(double x, double y, double z) {
        return normal.x * (point.x - x) + normal.y * (point.y - y) + normal.z * (point.z - z);
    }

    private double slope(double dx, double dy, double dz) {
        return normal.x * dx + normal.y * dy + normal.z * dz;
    }

    /** The inverse of the signed distance along a line: positive in front of the start, 0 at infinity. */
    public double inverseDistance(Ray line) {
        return slope(line.dx, line.dy, line.dz) / heightBelow(line.x, line.y, line.z);
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        SurfaceCoordinates coordinates = null;
        if (surface().usesCoordinates()) {
            Vector3d offset = new Vector3d(
                    ray.x + distance * ray.dx - point.x,
                    ray.y + distance * ray.dy - point.y,
                    ray.z + distance * ray.dz - point.z);
            coordinates = new SurfaceCoordinates(
                    offset.dot(first) * scale,
                    offset.dot(second) * scale,
                    first.mul(scale, new Vector3d()),
                    second.mul(scale, new Vector3d()));
        }
        return memory.set(ray, distance, normal.x, normal.y, normal.z, this, 0, coordinates);
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        return Double.NEGATIVE_INFINITY;
    }
}
