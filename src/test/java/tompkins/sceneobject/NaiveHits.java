package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Hits by the discriminant of the quadratic equation, and without a memory of where the ray starts. */
public final class NaiveHits implements HitMethod {

    @Override
    public double sphere(Vector3dc origin, Vector3dc direction, Vector3dc centre, double radius, boolean fromItself) {
        Vector3d from = origin.sub(centre, new Vector3d());
        return first(direction.lengthSquared(), from.dot(direction), from.lengthSquared() - radius * radius);
    }

    @Override
    public double plane(Vector3dc origin, Vector3dc direction, Vector3dc point, Vector3dc normal) {
        double distance = (normal.dot(point) - normal.dot(origin)) / normal.dot(direction);
        return distance > 0 ? distance : Double.POSITIVE_INFINITY;
    }

    @Override
    public double cylinder(
            Vector3dc origin, Vector3dc direction, Vector3dc start, Vector3dc end, double radius, boolean fromItself) {
        Vector3d axis = end.sub(start, new Vector3d()).normalize();
        Vector3d d = new Vector3d(axis).mul(-direction.dot(axis)).add(direction);
        Vector3d from = origin.sub(start, new Vector3d());
        from.sub(new Vector3d(axis).mul(from.dot(axis)));
        return first(d.lengthSquared(), from.dot(d), from.lengthSquared() - radius * radius);
    }

    /** The roots of (x.a)^2 = |x|^2 cos^2, a form with the unit axis a and half the opening angle at the tip. */
    @Override
    public double cone(
            Vector3dc origin, Vector3dc direction, Vector3dc tip, Vector3dc base, double radius, boolean fromItself) {
        Vector3d axis = base.sub(tip, new Vector3d());
        double height = axis.length();
        axis.div(height);
        double squaredCosine = height * height / (height * height + radius * radius);
        Vector3d from = origin.sub(tip, new Vector3d());
        double rayAlong = direction.dot(axis);
        double startAlong = from.dot(axis);
        double a = rayAlong * rayAlong - squaredCosine * direction.lengthSquared();
        double b = rayAlong * startAlong - squaredCosine * from.dot(direction);
        double c = startAlong * startAlong - squaredCosine * from.lengthSquared();
        double root = Math.sqrt(b * b - a * c);
        double one = withinCone((-b - root) / a, startAlong, rayAlong, height);
        double other = withinCone((-b + root) / a, startAlong, rayAlong, height);
        return Math.min(one, other);
    }

    private static double withinCone(double distance, double startAlong, double rayAlong, double height) {
        double along = startAlong + distance * rayAlong;
        return distance > 0 && along >= 0 && along <= height ? distance : Double.POSITIVE_INFINITY;
    }

    /** The gradient of that form. */
    @Override
    public Vector3d coneNormal(
            Vector3dc origin, Vector3dc direction, Vector3dc tip, Vector3dc base, double radius, double distance) {
        Vector3d axis = base.sub(tip, new Vector3d());
        double squaredCosine = axis.lengthSquared() / (axis.lengthSquared() + radius * radius);
        axis.normalize();
        Vector3d place = direction.mul(distance, new Vector3d()).add(origin).sub(tip);
        double along = place.dot(axis);
        return place.mul(squaredCosine).sub(axis.mul(along)).normalize();
    }

    /** The planes of the faces as seen from the centre of the box. */
    @Override
    public double box(Vector3dc origin, Vector3dc direction, Vector3dc from, Vector3dc to) {
        Vector3d centre = from.add(to, new Vector3d()).mul(0.5);
        Vector3d half = to.sub(from, new Vector3d()).mul(0.5);
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double start = origin.get(axis) - centre.get(axis);
            double one = (-half.get(axis) - start) / direction.get(axis);
            double other = (half.get(axis) - start) / direction.get(axis);
            enter = Math.max(enter, Math.min(one, other));
            leave = Math.min(leave, Math.max(one, other));
        }
        double distance = enter > 0 ? enter : leave;
        return enter <= leave && distance > 0 ? distance : Double.POSITIVE_INFINITY;
    }

    private static double first(double a, double b, double c) {
        double root = Math.sqrt(b * b - a * c);
        double near = (-b - root) / a;
        double far = (-b + root) / a;
        return near > 0 ? near : far > 0 ? far : Double.POSITIVE_INFINITY;
    }
}
