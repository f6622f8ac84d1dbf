package tompkins.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.io.BundledScenes;
import tompkins.primitive.Bounds;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.primitive.Rotation;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.trace.RenderPlan;
import tompkins.world.InertialFrame;

/**
 * How many hits on what turns are missed, with so many chords of a ray while it turns by a radian.
 *
 * @param seed of the objects and the rays
 * @param rays rays at objects of each kind
 */
record ChordStudy(long seed, int rays) implements Study {

    private static final String PROBLEM = "chords";
    private static final String SLIVERS = "slivers";
    private static final String SCENES = "bundled scenes";
    private static final double[] CHORDS = {4, 8, 16, 32, 64};
    private static final double REFERENCE = 256;
    private static final double MILLION = 1e6;
    private static final int OBJECTS = 8;

    /** Distances that differ by less are the same. */
    private static final double SAME = 1e-6;

    /** Primitives that turn together, rays past them, and where these meet them with the chords of the reference. */
    private record Target(List<Primitive> primitives, Ray[] rays, double[] distances) {

        static Target of(List<Primitive> primitives, Ray[] rays) {
            return new Target(primitives, rays, met(primitives, rays, REFERENCE));
        }
    }

    @Override
    public String settings() {
        return StudyText.of("chords.settings", seed, rays, OBJECTS, REFERENCE);
    }

    @Override
    public List<Trial> trials() {
        Map<String, Supplier<List<Target>>> kinds = new LinkedHashMap<>();
        kinds.put("balls", turning((at, along) -> new Sphere("", at, 0.2, ColouredSurface.DEFAULT)));
        kinds.put("boxes", turning(ChordStudy::box));
        kinds.put("rods", turning((at, along) -> cylinder(at, along, 0.3, 0.01)));
        kinds.put("thin rings", turning((at, along) -> cylinder(at, along, 0.005, 0.25)));
        kinds.put(SLIVERS, turning(ChordStudy::sliver));
        kinds.put(SCENES, this::inScenes);
        Map<String, List<Target>> targets = new HashMap<>();
        List<Trial> trials = new ArrayList<>();
        kinds.forEach((kind, first) -> {
            for (double chords : CHORDS) {
                trials.add(new Trial(
                        PROBLEM,
                        kind,
                        chords,
                        () -> measure(targets.computeIfAbsent(kind, unused -> first.get()), chords)));
            }
        });
        return trials;
    }

    /** What turns in the bundled scenes, and rays from their cameras through the space around it. */
    private List<Target> inScenes() {
        List<Target> targets = new ArrayList<>();
        for (Studio studio : BundledScenes.named().values()) {
            RenderPlan plan = RenderPlan.of(studio);
            for (InertialFrame frame : plan.world().frames()) {
                List<Primitive> turning = frame.objects().primitives().stream()
                        .filter(primitive -> primitive.restFrame().rotation() != null)
                        .toList();
                if (!turning.isEmpty()) {
                    Event lens = FrameTree.described(studio.transformation())
                            .route(null, frame.motion())
                            .transform(plan.lensInScene())
                            .minus(frame.origin());
                    targets.add(Target.of(turning, raysFrom(lens, turning)));
                }
            }
        }
        return targets;
    }

    /** Objects at random places and in random directions, the outermost nearly as fast as light; rays aim at them. */
    private Supplier<List<Target>> turning(BiFunction<Vector3d, Vector3d, SceneObject> kind) {
        return () -> {
            SplittableRandom random = new SplittableRandom(seed);
            List<SceneObject> objects = new ArrayList<>();
            for (int i = 0; i < OBJECTS; i++) {
                objects.add(kind.apply(inBall(random).mul(0.7), inBall(random).normalize()));
            }
            PrimitiveCollector collector =
                    new PrimitiveCollector(point -> Event.ORIGIN, FrameTree.described(TransformationLaw.LORENTZ));
            new Rotating("", new Vector3d(), new Vector3d(0, 1, 0), 0.95, 0, objects).addTo(collector, Placement.NONE);
            List<Primitive> primitives = collector.primitives();
            Ray[] all = new Ray[rays];
            Arrays.setAll(all, i -> at(primitives.get(random.nextInt(primitives.size())), random));
            return List.of(Target.of(primitives, all));
        };
    }

    private static SceneObject box(Vector3d at, Vector3d along) {
        Box box = new Box("", new Vector3d(-0.15), new Vector3d(0.15), ColouredSurface.DEFAULT);
        return new Placed("", box, 1, along, 50, at);
    }

    private static SceneObject cylinder(Vector3d at, Vector3d along, double half, double radius) {
        Vector3d start = new Vector3d(at).fma(-half, along);
        Vector3d end = new Vector3d(at).fma(half, along);
        return new Cylinder("", start, end, radius, half > radius, ColouredSurface.DEFAULT);
    }

    private static SceneObject sliver(Vector3d at, Vector3d along) {
        Vector3d across = along.cross(0.6, 0.8, 0, new Vector3d()).normalize(0.002);
        return new Triangle("", at, along.mul(0.3, new Vector3d()), across, ColouredSurface.DEFAULT);
    }

    private static Vector3d inBall(SplittableRandom random) {
        Vector3d place;
        do {
            place = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        } while (place.lengthSquared() > 1);
        return place;
    }

    private Ray[] raysFrom(Event lens, List<Primitive> turning) {
        SplittableRandom random = new SplittableRandom(seed);
        Bounds box =
                turning.stream().map(Primitive::allBounds).reduce(Bounds::with).orElseThrow();
        Ray[] all = new Ray[rays];
        for (int i = 0; i < rays; i++) {
            Vector3dc start = lens.position();
            Vector3d d = in(box, random).sub(start).normalize();
            all[i] = Ray.from(start.x(), start.y(), start.z(), d.x, d.y, d.z, lens.time() + random.nextDouble(100));
        }
        return all;
    }

    private static Vector3d in(Bounds box, SplittableRandom random) {
        return new Vector3d(
                random.nextDouble(box.minX(), Math.nextUp(box.maxX())),
                random.nextDouble(box.minY(), Math.nextUp(box.maxY())),
                random.nextDouble(box.minZ(), Math.nextUp(box.maxZ())));
    }

    /** A ray that passes a random place in the box around a primitive when that is there. */
    private static Ray at(Primitive primitive, SplittableRandom random) {
        Rotation rotation = primitive.restFrame().rotation();
        Vector3d described = in(primitive.bounds(), random);
        double time = random.nextDouble(0, 2 * Math.PI / Math.abs(rotation.angularSpeed()));
        Vector3d direction = inBall(random).normalize();
        double far = 4 * rotation.reach(primitive);
        Vector3d start = rotation.turned(described.sub(rotation.centre()), rotation.angle(time))
                .add(rotation.centre())
                .fma(-far, direction);
        return Ray.from(start.x, start.y, start.z, direction.x, direction.y, direction.z, time + far);
    }

    private static double[] met(List<Primitive> primitives, Ray[] rays, double chords) {
        ObjectTree tree = new ObjectTree(primitives, ObjectTree.SMALLEST_TREE, chords);
        NearestHit nearest = new NearestHit(new RayCounts());
        double[] distances = new double[rays.length];
        for (int i = 0; i < rays.length; i++) {
            distances[i] = tree.nearest(rays[i], nearest) ? nearest.distance() : Primitive.NO_HIT;
        }
        return distances;
    }

    private static Figures measure(List<Target> targets, double chords) {
        int count = 0;
        int missed = 0;
        for (Target target : targets) {
            double[] found = met(target.primitives, target.rays, chords);
            count += found.length;
            for (int i = 0; i < found.length; i++) {
                double expected = target.distances[i];
                missed += found[i] == expected || Math.abs(found[i] - expected) < SAME ? 0 : 1;
            }
        }
        // none at all would have no place on a logarithmic axis: half a ray stands for it
        return Figures.of(count, 0, Math.max(0.5, missed) * MILLION / count);
    }

    @Override
    public List<Chart> charts() {
        return List.of(new Chart(
                PROBLEM,
                "Hits on what turns that are missed",
                Chart.setting("chords for each radian"),
                new Chart.Axis("of a million rays", StudyPoint::error),
                false,
                ""));
    }

    @Override
    public void conclude(List<StudyPoint> all, Conclusion conclusion) {
        double slivers = StudyPoint.of(PROBLEM, SLIVERS, ObjectTree.CHORDS_PER_RADIAN, all)
                .medianError();
        conclusion.say("chords.answer", ObjectTree.CHORDS_PER_RADIAN, slivers);
        StudyPoint scenes = StudyPoint.of(PROBLEM, SCENES, ObjectTree.CHORDS_PER_RADIAN, all);
        double resolved = Math.max(1, MILLION / scenes.rays());
        conclusion.demand(
                scenes.medianError() <= resolved,
                "chords.missed",
                ObjectTree.CHORDS_PER_RADIAN,
                resolved,
                scenes.medianError());
    }
}
