package tompkins.trace;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.sceneobject.Primitive;
import tompkins.surface.Refractive;

/**
 * The medium around the lens: a camera may stand in glass or under water that moves with it. Which objects it stands in is told by
 * how often a line through the lens leaves them; infinite planes count with the side on which the lens is, other surfaces that
 * enclose nothing do not count.
 */
final class LensMedium {

    /** Any direction does in which lines meet no edges. */
    private static final Vector3dc LINE = new Vector3d(0.48, 0.6, 0.64);

    /** A line meets no primitive more often. */
    private static final int MOST_MEETINGS = 8;

    /** Relative error of a product of indices. */
    private static final double ROUNDING = 1e-9;

    private LensMedium() {}

    /** The slowness of light at a place among the primitives of the camera frame: the index of what is there, 1 in vacuum. */
    static double slowness(List<Primitive> primitives, Vector3dc place) {
        double slowness = 1;
        double ahead = 1;
        double behind = 1;
        for (Primitive primitive : primitives) {
            if (primitive.surface() instanceof Refractive medium) {
                double index = medium.indexRatio();
                double inFront = growth(primitive, index, place, LINE);
                double inBack = growth(primitive, index, place, LINE.negate(new Vector3d()));
                if (primitive.bounds() == null) {
                    // the line meets a plane once: it enters what is behind it, or leaves it
                    slowness *= inFront * inBack == index ? 1 : index;
                } else {
                    ahead *= inFront;
                    behind *= inBack;
                }
            }
        }
        boolean closed = Math.abs(ahead - behind) <= ROUNDING * ahead;
        return closed ? slowness / ahead : slowness;
    }

    /** The factor by which the slowness grows along a line that starts at a place, because of one primitive. */
    private static double growth(Primitive primitive, double index, Vector3dc from, Vector3dc line) {
        Ray ray = Ray.fromCamera(from.x(), from.y(), from.z(), line.x(), line.y(), line.z(), 0);
        double growth = 1;
        double distance = primitive.distance(ray, Primitive.NO_HIT);
        for (int meeting = 0; meeting < MOST_MEETINGS && distance < Primitive.NO_HIT; meeting++) {
            Hit hit = primitive.hit(ray, distance);
            growth *= hit.cosine(ray) < 0 ? index : 1 / index;
            ray = ray.straightOn(hit, 1);
            distance = primitive.distance(ray, Primitive.NO_HIT);
        }
        return growth;
    }
}
