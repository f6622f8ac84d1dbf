package tompkins.trace;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.sceneobject.Primitive;
import tompkins.surface.Refractive;

/**
 * The medium around the lens: a camera may stand in glass or under water that moves with it. What it stands in is told by how often
 * a line through the lens enters and leaves it. What encloses nothing does not count, but for infinite planes with the lens on
 * their inner side.
 */
final class LensMedium {

    /** Any direction does in which lines meet no edges and along which nobody lays a plane. */
    private static final Vector3dc LINE = new Vector3d(0.4871, 0.6113, 0.6237).normalize();

    /** Relative error of a product of indices. */
    private static final double ROUNDING = 1e-9;

    /** What a line through the lens crosses of one body, in front and behind. */
    private static final class Crossings {
        private double ahead = 1;
        private double behind = 1;
    }

    private LensMedium() {}

    /** The slowness of light at a place among the primitives of the camera frame: the index of what is there, 1 in vacuum. */
    static double slowness(List<Primitive> primitives, Vector3dc place) {
        double slowness = 1;
        Map<List<Object>, Crossings> bodies = new LinkedHashMap<>();
        for (Primitive primitive : primitives) {
            if (primitive.surface() instanceof Refractive medium) {
                double index = medium.indexRatio();
                double ahead = growth(primitive, index, place, LINE);
                double behind = growth(primitive, index, place, LINE.negate(new Vector3d()));
                if (primitive.bounds() == null) {
                    slowness *= ahead * behind == 1 / index ? index : 1;
                } else {
                    // a body may have many primitives, as a mesh has
                    Crossings body = bodies.computeIfAbsent(
                            List.of(primitive.description(), medium), description -> new Crossings());
                    body.ahead *= ahead;
                    body.behind *= behind;
                }
            }
        }
        for (Crossings body : bodies.values()) {
            boolean closed = Math.abs(body.ahead - body.behind) <= ROUNDING * body.ahead;
            slowness /= closed ? body.ahead : 1;
        }
        return slowness;
    }

    /** The factor by which the slowness grows along a line that starts at a place, because of one primitive. */
    private static double growth(Primitive primitive, double index, Vector3dc from, Vector3dc line) {
        Ray ray = Ray.fromCamera(from.x(), from.y(), from.z(), line.x(), line.y(), line.z(), 0);
        double growth = 1;
        double distance = primitive.distance(ray, Primitive.NO_HIT);
        for (int meeting = 0; meeting < Primitive.MOST_MEETINGS && distance < Primitive.NO_HIT; meeting++) {
            Hit hit = primitive.hit(ray, distance);
            growth *= hit.cosine(ray) < 0 ? index : 1 / index;
            ray = ray.straightOn(hit, 1);
            distance = primitive.distance(ray, Primitive.NO_HIT);
        }
        return growth;
    }
}
