package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
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
import tompkins.studio.LensEvent;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.trace.RenderPlan;
import tompkins.world.InertialFrame;

/**
 * How many hits on what turns are missed, with so many chords of a ray while it turns by a radian.
 *
 * @param seed of the objects and the rays
 */
record ChordStudy(long seed) implements Study {

    private static final String PROBLEM = "chords";
    private static final String SLIVERS = "slivers";
    private static final String SCENES = "bundled scenes";
    private static final double[] CHORDS = {4, 8, 16, 32, 64};
    private static final double REFERENCE = 256;
    private static final double MILLION = 1e6;
    private static final int OBJECTS = 8;
    private static final int RAYS = 200_000;

    /** Distances that differ by less are the same. */
    private static final double SAME = 1e-6;

    /** Primitives that turn together, rays past them, and where these meet them with the chords of the reference. */
    private record Target(List<Primitive> primitives, Ray[] rays, double[] distances) {}

    private static Target target(List<Primitive> primitives, Supplier<Ray> aimed) {
        Ray[] rays = Stream.generate(aimed).limit(RAYS).toArray(Ray[]::new);
        return new Target(primitives, rays, met(primitives, rays, REFERENCE));
    }

    @Override
    public String settings() {
        return StudyText.of("chords.settings", seed, RAYS, OBJECTS, REFERENCE);
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        trials.addAll(trials("balls", () -> turning((at, along) -> new Sphere("", at, 0.2, ColouredSurface.DEFAULT))));
        trials.addAll(trials("boxes", () -> turning(ChordStudy::box)));
        trials.addAll(trials("rods", () -> turning((at, along) -> cylinder(at, along, 0.3, 0.01))));
        trials.addAll(trials("thin rings", () -> turning((at, along) -> cylinder(at, along, 0.005, 0.25))));
        trials.addAll(trials(SLIVERS, () -> turning(ChordStudy::sliver)));
        trials.addAll(trials(SCENES, this::inScenes));
        return trials;
    }

    private static List<Trial> trials(String kind, Supplier<List<Target>> made) {
        List<Target> targets = new ArrayList<>();
        return DoubleStream.of(CHORDS)
                .mapToObj(chords -> new Trial(PROBLEM, kind, chords, () -> {
                    if (targets.isEmpty()) {
                        targets.addAll(made.get());
                    }
                    return measure(targets, chords);
                }))
                .toList();
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
                            .transform(LensEvent.inScene(plan.studio()))
                            .minus(frame.origin());
                    Bounds box = turning.stream()
                            .map(Primitive::allBounds)
                            .reduce(Bounds::with)
                            .orElseThrow();
                    SplittableRandom random = new SplittableRandom(seed);
                    targets.add(target(turning, () -> from(lens, in(box, random), random)));
                }
            }
        }
        return targets;
    }

    /** Objects at random places and in random directions, the outermost nearly as fast as light; rays aim at them. */
    private List<Target> turning(BiFunction<Vector3d, Vector3d, SceneObject> kind) {
        SplittableRandom random = new SplittableRandom(seed);
        List<SceneObject> objects = new ArrayList<>();
        for (int i = 0; i < OBJECTS; i++) {
            objects.add(kind.apply(inBall(random).mul(0.7), inBall(random).normalize()));
        }
        PrimitiveCollector collector =
                new PrimitiveCollector(point -> Event.ORIGIN, FrameTree.described(TransformationLaw.LORENTZ));
        new Rotating("", new Vector3d(), new Vector3d(0, 1, 0), 0.95, 0, objects).addTo(collector, Placement.NONE);
        List<Primitive> primitives = collector.primitives(0);
        return List.of(target(primitives, () -> at(primitives.get(random.nextInt(primitives.size())), random)));
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

    /** A random place in the ball of radius 1 around the origin. */
    static Vector3d inBall(SplittableRandom random) {
        Vector3d place;
        do {
            place = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        } while (place.lengthSquared() > 1);
        return place;
    }

    private static Ray from(Event lens, Vector3d place, SplittableRandom random) {
        return ray(lens.position(), place.sub(lens.position()).normalize(), lens.time() + random.nextDouble(100));
    }

    private static Ray ray(Vector3dc start, Vector3dc direction, double time) {
        return Ray.from(start.x(), start.y(), start.z(), direction.x(), direction.y(), direction.z(), time);
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
        return ray(start, direction, time + far);
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
