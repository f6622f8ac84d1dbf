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
import tompkins.property.NumberText;
import tompkins.ray.Hit;
import tompkins.ray.Medium;
import tompkins.ray.Ray;
import tompkins.search.ObjectTree;
import tompkins.spacetime.Event;
import tompkins.surface.Refractive;
import tompkins.world.FrameRoutes;
import tompkins.world.World;

/**
 * The medium around the lens: a camera may stand in glass or under water that moves with it. The medium is found by
 * counting how often a line through the lens leaves it. Open surfaces do not count, except infinite planes. Planes of
 * one medium are judged together, because two of them may be the faces of a plate.
 */
final class LensMedium {

    /** Any direction will do in which lines are unlikely to meet edges or run along planes. */
    private static final Vector3dc LINE = new Vector3d(0.4871, 0.6113, 0.6237).normalize();

    private LensMedium() {}

    /** The medium at an event of the camera frame: of what moves with it, or else of the scene; null in vacuum. */
    static Medium around(Event lens, ObjectTree cameraFrame, World world, FrameRoutes routes) {
        double index = index(cameraFrame, lens.position());
        int frame = routes.camera();
        for (int i = 0; i < world.frames().size() && index == 1; i++) {
            frame = i;
            index = index(
                    world.objects(i),
                    routes.route(routes.camera(), i).transform(lens).position());
        }
        return index == 1 ? null : new Medium(index, frame, null);
    }

    /** What a medium does to the picture of a camera that rests in it, in sentences; none for vacuum, which is null. */
    static List<String> sentences(Medium medium) {
        return medium == null
                ? List.of()
                : List.of("The lens rests in a medium of index " + NumberText.plain(medium.index(), 4)
                        + ": behind a flat face across the view, what is in the middle of the picture stays there at any"
                        + " speed, as without the medium, and sines of angles to the middle are divided by the index.");
    }

    /** The index of what is at a place among objects: 1 in vacuum. */
    private static double index(ObjectTree objects, Vector3dc place) {
        if (objects.surfaces().stream().noneMatch(Refractive.class::isInstance)) {
            return 1;
        }
        // a body may have many primitives, like a mesh
        Map<List<Object>, List<Primitive>> bodies = objects.primitives().stream()
                .filter(primitive -> primitive.surface() instanceof Refractive)
                .collect(Collectors.groupingBy(
                        primitive -> primitive.bounds() == null
                                ? List.of(primitive.surface())
                                : List.of(primitive.surface(), primitive.description()),
                        LinkedHashMap::new,
                        Collectors.toList()));
        double index = 1;
        for (List<Primitive> body : bodies.values()) {
            Primitive first = body.get(0);
            Collection<Integer> ahead = crossings(body, place, LINE);
            Collection<Integer> behind = crossings(body, place, LINE.negate(new Vector3d()));
            int depth = first.bounds() == null
                    ? Math.max(mostLeft(ahead), mostLeft(behind))
                    : left(ahead) == left(behind) ? left(ahead) : 0;
            index *= Math.pow(((Refractive) first.surface()).indexRatio(), depth);
        }
        return index;
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
