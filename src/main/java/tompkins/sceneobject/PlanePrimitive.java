package tompkins.sceneobject;

import org.joml.Vector3d;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;

/** An infinite plane in space. */
final class PlanePrimitive extends Primitive {

    private final Vector3d point;
    private final Vector3d normal;
    private final Vector3d first;
    private final Vector3d second;
    private final double scale;

    PlanePrimitive(Plane plane, Placement placement) {
        super(plane.description(), plane.surface());
        Vector3d unit = Vectors.unit(plane.normal());
        Vector3d axis = Vectors.firstAxis(unit);
        point = placement.point(plane.point());
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
        double distance = heightBelow(ray) / (normal.x * ray.dx + normal.y * ray.dy + normal.z * ray.dz);
        return distance > 0 && distance <= limit ? distance : NO_HIT;
    }

    /** The normal times (point - start): subtracted first, so that nothing cancels near the plane. */
    private double heightBelow(Ray ray) {
        return normal.x * (point.x - ray.x) + normal.y * (point.y - ray.y) + normal.z * (point.z - ray.z);
    }

    @Override
    public double inverseDistance(Ray line) {
        return (normal.x * line.dx + normal.y * line.dy + normal.z * line.dz) / heightBelow(line);
    }

    @Override
    public Hit hit(Ray ray, double distance) {
        SurfaceCoordinates coordinates = null;
        if (surface().usesCoordinates()) {
            Vector3d offset = new Vector3d(
                    ray.x + distance * ray.dx - point.x,
                    ray.y + distance * ray.dy - point.y,
                    ray.z + distance * ray.dz - point.z);
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
        return new Hit(ray, distance, normal.x, normal.y, normal.z, this, 0, coordinates);
    }

    @Override
    public double least(double nx, double ny, double nz) {
        return Double.NEGATIVE_INFINITY;
    }

    /** Null: a plane has no end. */
    @Override
    public Bounds bounds() {
        return null;
    }
}
