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

    private final Vector3d first;
    private final Vector3d second;
    private final double scale;

    // as plain numbers, because every ray asks for them
    private final double pointX;
    private final double pointY;
    private final double pointZ;
    private final double normalX;
    private final double normalY;
    private final double normalZ;

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
        Vector3d point = placement.point(describedPoint);
        Vector3d normal = placement.direction(unit);
        first = placement.direction(axis);
        second = placement.direction(Vectors.secondAxis(unit, axis));
        scale = 1 / placement.scale();
        pointX = point.x;
        pointY = point.y;
        pointZ = point.z;
        normalX = normal.x;
        normalY = normal.y;
        normalZ = normal.z;
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
    public boolean overlaps(RayPacket rays, RayStarts starts, double[] overlaps) {
        if (!hasSquare(starts.farthest() + Math.abs(pointX) + Math.abs(pointY) + Math.abs(pointZ))) {
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

    @Override
    public boolean surelyMisses(Hit from, double dx, double dy, double dz) {
        return from.boundary == this || heightBelow(from.x, from.y, from.z) * slope(dx, dy, dz) < 0;
    }

    /** The normal times (point - start), subtracted first so that no digits are lost near the plane. */
    private double heightBelow(double x, double y, double z) {
        return normalX * (pointX - x) + normalY * (pointY - y) + normalZ * (pointZ - z);
    }

    private double slope(double dx, double dy, double dz) {
        return normalX * dx + normalY * dy + normalZ * dz;
    }

    @Override
    public double inverseDistance(Ray line) {
        return slope(line.dx, line.dy, line.dz) / heightBelow(line.x, line.y, line.z);
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        SurfaceCoordinates coordinates = null;
        if (surface().usesCoordinates()) {
            Vector3d offset = new Vector3d(
                    ray.x + distance * ray.dx - pointX,
                    ray.y + distance * ray.dy - pointY,
                    ray.z + distance * ray.dz - pointZ);
            coordinates = new SurfaceCoordinates(
                    offset.dot(first) * scale,
                    offset.dot(second) * scale,
                    first.x * scale,
                    first.y * scale,
                    first.z * scale,
                    second.x * scale,
                    second.y * scale,
                    second.z * scale);
        }
        return memory.set(ray, distance, normalX, normalY, normalZ, this, 0, coordinates);
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        return Double.NEGATIVE_INFINITY;
    }

    /** Null: a plane has no end. */
    @Override
    public Bounds bounds() {
        return null;
    }
}
