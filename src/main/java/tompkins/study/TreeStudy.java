package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.IntFunction;
import org.joml.Vector3d;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.surface.ColouredSurface;

/**
 * From how many objects on a tree is faster.
 *
 * @param seed of the objects and the rays
 */
record TreeStudy(long seed) implements Study {

    private static final String SPHERES = "spheres";
    private static final String LIST = "list";
    private static final String TREE = "tree";
    private static final String PROGRAM = "the program's choice";
    private static final int RAYS = 20_000;
    private static final int LONGEST_LIST = 10_000;
    private static final int MOST_OBJECTS = 1_000_000;
    private static final int REPEATS = 3;

    /** Runs for up to {@link #MANY} objects, whose times are short. */
    private static final int REPEATS_OF_FEW = 25;

    private static final double TOLERANCE = 1.5;
    private static final int MANY = 1000;
    private static final int[] STEPS = {10, 20, 30, 40, 60, 80};
    private static final int[] STEPS_OF_MANY = {10, 20, 50};

    @Override
    public String settings() {
        return StudyText.of("tree.settings", seed, MOST_OBJECTS, RAYS, REPEATS_OF_FEW, REPEATS, MANY);
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        for (int decade = 1; 10 * decade <= MOST_OBJECTS; decade *= 10) {
            for (int step : 10 * decade < MANY ? STEPS : STEPS_OF_MANY) {
                if (step * decade <= MOST_OBJECTS) {
                    trials.addAll(race(step * decade));
                }
            }
        }
        return trials;
    }

    /** All methods with the same objects and rays. */
    private List<Trial> race(int objects) {
        Map<String, IntFunction<Figures>> methods = new LinkedHashMap<>();
        if (objects <= LONGEST_LIST) {
            methods.put(LIST, run -> search(objects, Integer.MAX_VALUE));
        }
        methods.put(TREE, run -> search(objects, 1));
        methods.put(PROGRAM, run -> search(objects, ObjectTree.SMALLEST_TREE));
        return Race.trials(SPHERES, objects, methods, objects <= MANY ? REPEATS_OF_FEW : REPEATS);
    }

    private Figures search(int objects, int smallestTree) {
        List<Primitive> primitives = spheres(objects);
        Ray[] rays = rays();
        NearestHit nearest = new NearestHit(new RayCounts());
        double seconds = Race.seconds(() -> {
            ObjectTree tree = new ObjectTree(primitives, smallestTree);
            for (Ray ray : rays) {
                tree.nearest(ray, nearest);
            }
        });
        return Figures.of(RAYS, seconds, 0);
    }

    private List<Primitive> spheres(int count) {
        SplittableRandom random = new SplittableRandom(seed);
        // they cover the same fraction of the view, whatever their number
        double radius = 0.25 / Math.sqrt(count);
        List<SceneObject> spheres = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Vector3d centre = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(1, 3));
            spheres.add(new Sphere("sphere", centre, radius, ColouredSurface.DEFAULT));
        }
        return PrimitiveCollector.primitivesOf(new Group("spheres", spheres));
    }

    private Ray[] rays() {
        SplittableRandom random = new SplittableRandom(seed + 1);
        Ray[] rays = new Ray[RAYS];
        for (int i = 0; i < RAYS; i++) {
            Vector3d direction =
                    new Vector3d(random.nextDouble(-0.5, 0.5), random.nextDouble(-0.5, 0.5), 1).normalize();
            rays[i] = Ray.from(0, 0, 0, direction.x, direction.y, direction.z, 0);
        }
        return rays;
    }

    @Override
    public List<Chart> charts() {
        return List.of(new Chart(
                SPHERES,
                "List against tree, building included",
                Chart.setting("objects"),
                Chart.SECONDS,
                false,
                PROGRAM));
    }

    @Override
    public void conclude(List<StudyPoint> all, Conclusion conclusion) {
        // the smallest number of objects from which on the tree is always faster, of those measured
        double crossing = Double.POSITIVE_INFINITY;
        double slower = 0;
        double at = Double.NaN;
        List<StudyPoint> lists = StudyPoint.of(SPHERES, LIST, all);
        for (StudyPoint list : lists) {
            double objects = list.setting();
            double tree = seconds(TREE, objects, all);
            crossing = tree < list.medianSeconds() ? Math.min(crossing, objects) : Double.POSITIVE_INFINITY;
            double ratio = seconds(PROGRAM, objects, all) / Math.min(list.medianSeconds(), tree);
            if (objects <= MANY && ratio > slower) {
                slower = ratio;
                at = objects;
            }
        }
        StudyPoint longest = lists.get(lists.size() - 1);
        conclusion.say(
                "tree.answer",
                crossing < Double.POSITIVE_INFINITY ? StudyText.format("%.0f", crossing) : "no number of",
                longest.setting(),
                longest.medianSeconds() / seconds(TREE, longest.setting(), all),
                ObjectTree.SMALLEST_TREE);
        conclusion.demand(slower <= TOLERANCE, "tree.time", TOLERANCE, MANY, slower, at);
    }

    private static double seconds(String method, double objects, List<StudyPoint> all) {
        return StudyPoint.of(SPHERES, method, objects, all).medianSeconds();
    }
}
