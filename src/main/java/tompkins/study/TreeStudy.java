package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import org.joml.Vector3d;
import tompkins.ray.Ray;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.NearestHit;
import tompkins.sceneobject.ObjectTree;
import tompkins.sceneobject.Primitive;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.surface.ColouredSurface;

/** From how many objects on a tree pays. */
final class TreeStudy implements Study {

    private static final String SPHERES = "spheres";
    private static final String LIST = "list";
    private static final String TREE = "tree";
    private static final int RAYS = 20_000;
    private static final int LONGEST_LIST = 10_000;
    private static final int REPEATS = 3;
    private static final int MANY_REPEATS = 15;
    private static final double TOLERANCE = 1.3;

    private final long seed;
    private final int mostObjects;

    /** The study, up to a number of objects. */
    TreeStudy(long seed, int mostObjects) {
        this.seed = seed;
        this.mostObjects = mostObjects;
    }

    @Override
    public String name() {
        return "tree";
    }

    @Override
    public String question() {
        return "A bounding-volume tree finds the nearest object without looking at all of them, but has to be built and"
                + " walked through. From how many objects on does it pay? Random rays meet spheres; the time holds building"
                + " and " + RAYS + " rays.";
    }

    @Override
    public String settings() {
        return "seed " + seed + ", up to " + mostObjects + " objects, " + RAYS + " rays, " + MANY_REPEATS + " runs, "
                + REPEATS + " above " + LONGEST_LIST;
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        for (int decade = 10; decade <= mostObjects; decade *= 10) {
            for (int objects : new int[] {decade, 2 * decade, 5 * decade}) {
                if (objects > mostObjects) {
                    break;
                }
                if (objects <= LONGEST_LIST) {
                    trials.add(trial(LIST, objects, Integer.MAX_VALUE));
                }
                trials.add(trial(TREE, objects, 1));
            }
        }
        return trials;
    }

    private Trial trial(String method, int objects, int smallestTree) {
        return new Trial(SPHERES, method, objects, cancelled -> measure(method, objects, smallestTree, cancelled));
    }

    private Measurement measure(String method, int objects, int smallestTree, BooleanSupplier cancelled) {
        List<Primitive> primitives = spheres(objects);
        Ray[] rays = rays();
        if (objects <= LONGEST_LIST) {
            for (int i = 0; i < REPEATS; i++) {
                Stopwatch.warmUp(() -> search(new ObjectTree(primitives, smallestTree), rays), cancelled);
            }
        }
        double[] seconds = new double[objects <= LONGEST_LIST ? MANY_REPEATS : REPEATS];
        for (int i = 0; i < seconds.length; i++) {
            Stopwatch.stopIf(cancelled);
            seconds[i] = Stopwatch.seconds(() -> search(new ObjectTree(primitives, smallestTree), rays));
        }
        double different = objects <= LONGEST_LIST ? differences(primitives, smallestTree, rays) : 0;
        return new Measurement(
                SPHERES, method, objects, RAYS, Spread.of(seconds), Spread.exact(different), different, different, 0);
    }

    private static double search(ObjectTree tree, Ray[] rays) {
        NearestHit nearest = new NearestHit();
        double sum = 0;
        for (Ray ray : rays) {
            sum += tree.nearest(ray, nearest) ? nearest.distance() : 0;
        }
        return sum;
    }

    /** How many rays find another object, or the same one at a distance that differs in any bit, than with a list. */
    private static int differences(List<Primitive> primitives, int smallestTree, Ray[] rays) {
        ObjectTree list = new ObjectTree(primitives, Integer.MAX_VALUE);
        ObjectTree tree = new ObjectTree(primitives, smallestTree);
        NearestHit inList = new NearestHit();
        NearestHit inTree = new NearestHit();
        int different = 0;
        for (Ray ray : rays) {
            boolean hit = list.nearest(ray, inList);
            boolean same = tree.nearest(ray, inTree) == hit
                    && (!hit || (inList.primitive() == inTree.primitive() && inList.distance() == inTree.distance()));
            different += same ? 0 : 1;
        }
        return different;
    }

    private List<Primitive> spheres(int count) {
        SplittableRandom random = new SplittableRandom(seed);
        // the same share of the view is covered whatever their number
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
            rays[i] = Ray.fromCamera(0, 0, 0, direction.x, direction.y, direction.z, 0);
        }
        return rays;
    }

    @Override
    public List<Chart> charts() {
        return List.of(new Chart(
                SPHERES, "List against tree, building included", Chart.setting("objects"), Chart.TIME, false));
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        double crossing = Double.NaN;
        double worst = 0;
        for (Measurement list : points(LIST, all)) {
            double tree = seconds(TREE, list.setting(), all);
            double own = list.setting() >= ObjectTree.SMALLEST_TREE
                    ? tree
                    : list.seconds().low();
            worst = Math.max(worst, own / Math.min(tree, list.seconds().low()));
            if (Double.isNaN(crossing) && tree < list.seconds().low()) {
                crossing = list.setting();
            }
        }
        double different = all.stream().mapToDouble(Measurement::maximum).max().orElse(0);
        return List.of(
                Finding.note(
                        "The tree is faster from %.0f objects on, of those measured; the program builds one from %d on.",
                        crossing, ObjectTree.SMALLEST_TREE),
                Finding.check(
                        worst <= TOLERANCE,
                        "The program's choice takes at most %.2f times as long as the better of both; %.1f is allowed.",
                        worst,
                        TOLERANCE),
                Finding.check(
                        different == 0,
                        "List and tree find the same object at the same distance, to the last bit; %.0f rays differ.",
                        different));
    }

    private static List<Measurement> points(String method, List<Measurement> all) {
        return all.stream().filter(point -> point.method().equals(method)).toList();
    }

    /** The fastest run: other work on the machine only adds to the time. */
    private static double seconds(String method, double objects, List<Measurement> all) {
        return points(method, all).stream()
                .filter(point -> point.setting() == objects)
                .mapToDouble(point -> point.seconds().low())
                .findFirst()
                .orElse(Double.NaN);
    }
}
