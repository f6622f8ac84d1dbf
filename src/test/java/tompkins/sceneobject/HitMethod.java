package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.surface.ColouredSurface;

/** A way to find where a ray meets a sphere, a plane or a cylinder. */
public interface HitMethod {

    /** Distance of the first hit in front, in lengths of the direction; infinite if there is none. */
    double sphere(Vector3dc origin, Vector3dc direction, Vector3dc centre, double radius);

    /** As {@link #sphere}, for a ray that starts on the sphere. */
    double sphereFromItself(Vector3dc origin, Vector3dc direction, Vector3dc centre, double radius);

    /** Distance of a plane. */
    double plane(Vector3dc origin, Vector3dc direction, Vector3dc point, Vector3dc normal);

    /** Distance of the first hit of the mantle of a cylinder. */
    double cylinder(Vector3dc origin, Vector3dc direction, Vector3dc start, Vector3dc end, double radius);

    /** As {@link #cylinder}, for a ray that starts on the mantle. */
    double cylinderFromItself(Vector3dc origin, Vector3dc direction, Vector3dc start, Vector3dc end, double radius);

    /** The way of the program: the primitives of its objects. */
    HitMethod PROGRAM = new HitMethod() {

        @Override
        public double sphere(Vector3dc origin, Vector3dc direction, Vector3dc centre, double radius) {
            return distance(new Sphere("", centre, radius, ColouredSurface.DEFAULT), origin, direction, false);
        }

        @Override
        public double sphereFromItself(Vector3dc origin, Vector3dc direction, Vector3dc centre, double radius) {
            return distance(new Sphere("", centre, radius, ColouredSurface.DEFAULT), origin, direction, true);
        }

        @Override
        public double plane(Vector3dc origin, Vector3dc direction, Vector3dc point, Vector3dc normal) {
            return distance(new Plane("", point, normal, ColouredSurface.DEFAULT), origin, direction, false);
        }

        @Override
        public double cylinder(Vector3dc origin, Vector3dc direction, Vector3dc start, Vector3dc end, double radius) {
            return distance(
                    new Cylinder("", start, end, radius, false, ColouredSurface.DEFAULT), origin, direction, false);
        }

        @Override
        public double cylinderFromItself(
                Vector3dc origin, Vector3dc direction, Vector3dc start, Vector3dc end, double radius) {
            return distance(
                    new Cylinder("", start, end, radius, false, ColouredSurface.DEFAULT), origin, direction, true);
        }

        private double distance(SceneObject object, Vector3dc origin, Vector3dc direction, boolean fromItself) {
            Primitive primitive = PrimitiveCollector.primitivesOf(object).get(0);
            Vector3d d = direction.normalize(new Vector3d());
            Ray ray = Ray.from(origin.x(), origin.y(), origin.z(), d.x, d.y, d.z, 0);
            if (fromItself) {
                Hit start = Hit.blank().set(ray, 0, 0, 0, 0, primitive, 0, null);
                ray = ray.bent(start, d.x, d.y, d.z, 1);
            }
            return primitive.distance(ray, Primitive.NO_HIT) / direction.length();
        }
    };
}
