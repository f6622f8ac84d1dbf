package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.surface.ColouredSurface;

/** A way to find where a ray meets a sphere, a plane, a cylinder, a cone or a box. */
public interface HitMethod {

    /**
     * Distance of the first hit in front, in lengths of the direction; infinite if there is none.
     *
     * @param fromItself whether the ray starts on the sphere; so for the mantles of cylinders and cones
     */
    double sphere(Vector3dc origin, Vector3dc direction, Vector3dc centre, double radius, boolean fromItself);

    /** Distance of a plane. */
    double plane(Vector3dc origin, Vector3dc direction, Vector3dc point, Vector3dc normal);

    /** Distance of the first hit of the mantle of a cylinder. */
    double cylinder(
            Vector3dc origin, Vector3dc direction, Vector3dc start, Vector3dc end, double radius, boolean fromItself);

    /** Distance of the first hit of the mantle of a cone. */
    double cone(
            Vector3dc origin, Vector3dc direction, Vector3dc tip, Vector3dc base, double radius, boolean fromItself);

    /** Normal of the mantle of a cone, outwards, where a ray that hits it meets it after a distance. */
    Vector3d coneNormal(
            Vector3dc origin, Vector3dc direction, Vector3dc tip, Vector3dc base, double radius, double distance);

    /** Distance of the first hit of a box along the axes. */
    double box(Vector3dc origin, Vector3dc direction, Vector3dc from, Vector3dc to);

    /** The way of the program: the primitives of its objects. */
    HitMethod PROGRAM = new HitMethod() {
        @Override
        public double sphere(
                Vector3dc origin, Vector3dc direction, Vector3dc centre, double radius, boolean fromItself) {
            return distance(new Sphere("", centre, radius, ColouredSurface.DEFAULT), origin, direction, fromItself);
        }

        @Override
        public double plane(Vector3dc origin, Vector3dc direction, Vector3dc point, Vector3dc normal) {
            return distance(new Plane("", point, normal, ColouredSurface.DEFAULT), origin, direction, false);
        }

        @Override
        public double cylinder(
                Vector3dc origin,
                Vector3dc direction,
                Vector3dc start,
                Vector3dc end,
                double radius,
                boolean fromItself) {
            Cylinder mantle = new Cylinder("", start, end, radius, false, ColouredSurface.DEFAULT);
            return distance(mantle, origin, direction, fromItself);
        }

        @Override
        public double cone(
                Vector3dc origin,
                Vector3dc direction,
                Vector3dc tip,
                Vector3dc base,
                double radius,
                boolean fromItself) {
            return distance(mantle(tip, base, radius), origin, direction, fromItself);
        }

        private Cone mantle(Vector3dc tip, Vector3dc base, double radius) {
            return new Cone("", tip, base, radius, false, ColouredSurface.DEFAULT);
        }

        @Override
        public Vector3d coneNormal(
                Vector3dc origin, Vector3dc direction, Vector3dc tip, Vector3dc base, double radius, double distance) {
            Primitive primitive =
                    PrimitiveCollector.primitivesOf(mantle(tip, base, radius)).get(0);
            Hit hit = primitive.hit(ray(origin, direction), distance * direction.length());
            return new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        }

        @Override
        public double box(Vector3dc origin, Vector3dc direction, Vector3dc from, Vector3dc to) {
            return distance(new Box("", from, to, ColouredSurface.DEFAULT), origin, direction, false);
        }

        private double distance(SceneObject object, Vector3dc origin, Vector3dc direction, boolean fromItself) {
            Primitive primitive = PrimitiveCollector.primitivesOf(object).get(0);
            Ray ray = ray(origin, direction);
            if (fromItself) {
                Hit start = Hit.blank().set(ray, 0, 0, 0, 0, primitive, 0, null);
                ray = ray.bent(start, ray.dx, ray.dy, ray.dz, 1);
            }
            return primitive.distance(ray, Primitive.NO_HIT) / direction.length();
        }

        private Ray ray(Vector3dc origin, Vector3dc direction) {
            Vector3d d = direction.normalize(new Vector3d());
            return Ray.from(origin.x(), origin.y(), origin.z(), d.x, d.y, d.z, 0);
        }
    };
}
