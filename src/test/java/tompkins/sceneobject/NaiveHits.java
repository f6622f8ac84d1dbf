package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Hits by the discriminant of the quadratic equation, and without a memory of where the ray starts. */
public final class NaiveHits implements HitMethod {

    @Override
    public double sphere(Vector3dc origin, Vector3dc direction, Vector3dc centre, double radius) {
        Vector3d from = origin.sub(centre, new Vector3d());
        return first(direction.lengthSquared(), from.dot(direction), from.lengthSquared() - radius * radius);
    }

    @Override
    public double sphereFromItself(Vector3dc origin, Vector3dc direction, Vector3dc centre, double radius) {
        return sphere(origin, direction, centre, radius);
    }

    @Override
    public double plane(Vector3dc origin, Vector3dc direction, Vector3dc point, Vector3dc normal) {
        double distance = (normal.dot(point) - normal.dot(origin)) / normal.dot(direction);
        return distance > 0 ? distance : Double.POSITIVE_INFINITY;
    }

    @Override
    public double cylinder(Vector3dc origin, Vector3dc direction, Vector3dc start, Vector3dc end, double radius) {
        Vector3d axis = end.sub(start, new Vector3d()).normalize();
        Vector3d d = new Vector3d(axis).mul(-direction.dot(axis)).add(direction);
        Vector3d from = origin.sub(start, new Vector3d());
        from.sub(new Vector3d(axis).mul(from.dot(axis)));
        return first(d.lengthSquared(), from.dot(d), from.lengthSquared() - radius * radius);
    }

    @Override
    public double cylinderFromItself(
            Vector3dc origin, Vector3dc direction, Vector3dc start, Vector3dc end, double radius) {
        return cylinder(origin, direction, start, end, radius);
    }

    private static double first(double a, double b, double c) {
        double root = Math.sqrt(b * b - a * c);
        double near = (-b - root) / a;
        double far = (-b + root) / a;
        return near > 0 ? near : far > 0 ? far : Double.POSITIVE_INFINITY;
    }
}
