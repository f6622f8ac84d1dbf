package tompkins.trace;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.surface.Refractive;

/**
 * The medium around the lens: a camera may stand in glass or under water that moves with it. The medium is found by
 * counting how often a line through the lens leaves it. Open surfaces do not count, except infinite planes. Planes of
 * one medium are judged together, because two of them may be the faces of a plate.
 */
final class LensMedium {

    /** Any direction will do in which lines are unlikely to meet edges or run along planes. */
    private static final Vector3dc LINE = new Vector3d(0.4871, 0.6113, 0.6237).normalize();

    private LensMedium() {}

    /**
     * The slowness of light at a place among the primitives of the camera frame: the index of what is there, 1 in
     * vacuum.
     */
    static double slowness(List<Primitive> primitives, Vector3dc place) {
        // a body may have many primitives, like a mesh
        Map<List<Object>, List<Primitive>> bodies = primitives.stream()
                .filter(primitive -> primitive.surface() instanceof Refractive)
                .collect(Collectors.groupingBy(
                        primitive -> primitive.bounds() == null
                                ? List.of(primitive.surface())
                                : List.of(primitive.surface(), primitive.description()),
                        LinkedHashMap::new,
                        Collectors.toList()));
        double slowness = 1;
        for (List<Primitive> body : bodies.values()) {
            Primitive first = body.get(0);
            double index = ((Refractive) first.surface()).indexRatio();
            Collection<Integer> ahead = crossings(body, place, LINE);
            Collection<Integer> behind = crossings(body, place, LINE.negate(new Vector3d()));
            int depth = first.bounds() == null
                    ? Math.max(mostLeft(ahead), mostLeft(behind))
                    : left(ahead) == left(behind) ? left(ahead) : 0;
            slowness *= Math.pow(index, depth);
        }
        return slowness;
    }

    /**
     * The crossings of a line from a place on, the nearest first: 1 where it leaves the body, -1 where it enters it.
     */
    private static Collection<Integer> crossings(List<Primitive> body, Vector3dc from, Vector3dc line) {
        TreeMap<Double, Integer> crossings = new TreeMap<>();
        for (Primitive primitive : body) {
            Ray ray = Ray.from(from.x(), from.y(), from.z(), line.x(), line.y(), line.z(), 0);
            double before = 0;
            double distance = primitive.distance(ray, Primitive.NO_HIT);
            for (int meeting = 0; meeting < Primitive.MOST_MEETINGS && distance < Primitive.NO_HIT; meeting++) {
                Hit hit = primitive.hit(ray, distance);
                before += distance;
                crossings.merge(before, hit.cosine(ray) < 0 ? -1 : 1, Integer::sum);
                ray = ray.straightOn(hit, 1);
                distance = primitive.distance(ray, Primitive.NO_HIT);
            }
        }
        return crossings.values();
    }

    /** How many times more the line leaves than it enters. */
    private static int left(Collection<Integer> crossings) {
        return crossings.stream().mapToInt(Integer::intValue).sum();
    }

    /**
     * The largest such number along the line, at least 0: a line leaves only plates that it has entered, or in which it
     * starts.
     */
    private static int mostLeft(Collection<Integer> crossings) {
        int most = 0;
        int left = 0;
        for (int crossing : crossings) {
            left += crossing;
            most = Math.max(most, left);
        }
        return most;
    }
}
