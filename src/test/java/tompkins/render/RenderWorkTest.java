package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3i;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.EyeView;
import tompkins.camera.SamplePositions;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Refractive;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;

/**
 * Holds the work that pictures need, without a clock: it is counted exactly and must not grow. Rays and shadow rays
 * follow from the scene; nodes and tests are what the search makes of them. Who makes it better lowers the numbers.
 */
class RenderWorkTest {

    private static final long BYTES_PER_SAMPLE = 200;

    @ParameterizedTest(name = "{index}")
    @MethodSource("pictures")
    void workDoesNotGrow(Studio studio, long rays, long shadowRays, long mostNodes, long mostTests)
            throws InterruptedException {
        RenderReport report;
        try (Renderer renderer = new Renderer(2)) {
            report = renderer.render(RenderPlan.of(studio)).report();
        }

        assertThat(report.counts().rays).as("rays").isEqualTo(rays);
        assertThat(report.counts().shadowRays).as("shadow rays").isEqualTo(shadowRays);
        assertThat(report.counts().nodes).as("nodes").isLessThanOrEqualTo(mostNodes);
        assertThat(report.counts().tests).as("tests").isLessThanOrEqualTo(mostTests);
    }

    static Stream<Arguments> pictures() {
        CylinderLattice usual = CylinderLattice.DEFAULT;
        CylinderLattice large = new CylinderLattice(
                "large lattice",
                usual.from(),
                usual.to().add(0, 0, 40, new Vector3d()),
                new Vector3i(20, 20, 60),
                0.005,
                usual.surfaceAlongX(),
                usual.surfaceAlongY(),
                usual.surfaceAlongZ());
        Studio rods = PaperStudios.fig1b().withScene(List.of(large));
        // the tree searches for the shadows of so many hills, since there are more of them than the picture has rays
        return Stream.of(
                arguments(PaperStudios.fig1a(), 307_200, 231_021, 0, 397_525),
                arguments(PaperStudios.fig1b(), 307_200, 26_054, 0, 79_697),
                arguments(samples(PaperStudios.fig3a(), 4), 1_228_800, 130_486, 0, 524_233),
                arguments(rods, 307_200, 59_446, 6_307_600, 2_729_544),
                arguments(PaperStudios.fig1a().withScene(spheres()), 307_200, 270_501, 2_051, 465_413),
                arguments(small(PaperStudios.fig1a().withScene(hills())), 19_200, 19_200, 760_513, 336_677));
    }

    /** A camera that moves before things at rest, and the other way round: what is searched is the same. */
    @ParameterizedTest(name = "{index}")
    @MethodSource("worlds")
    void motionCostsNoMoreThanTheSameAtRest(List<SceneObject> scene) throws InterruptedException {
        Studio paper = small(PaperStudios.fig1a().withScene(scene)).withVelocity(Velocity.of(0.2, -0.1, 0.3));
        Velocity beta = paper.velocity();
        RenderReport rest = report(Lighting.of(paper, List.of(lamp())));
        Velocity back = Velocity.of(beta.components().negate(new Vector3d()));
        RenderReport moving = report(Lighting.of(
                paper.withScene(List.of(new Moving("", back, new Vector3d(), 0, scene)))
                        .withVelocity(Velocity.REST),
                List.of(new MovingLights(back, new Vector3d(), List.of(lamp())))));

        assertThat(rest.counts().rays).isPositive();
        assertThat(rest.counts().shadowRays).isPositive();
        // rays on the edges of things may fall on the other side
        assertThat(moving.counts().rays).as("rays").isEqualTo(rest.counts().rays);
        assertThat(moving.counts().shadowRays)
                .as("shadow rays")
                .isCloseTo(rest.counts().shadowRays, withinPercentage(0.1));
        assertThat(moving.counts().nodes)
                .as("nodes")
                .isLessThanOrEqualTo(rest.counts().nodes + rest.counts().nodes / 50);
        assertThat(moving.counts().tests)
                .as("tests")
                .isLessThanOrEqualTo(rest.counts().tests + rest.counts().tests / 50);
    }

    static Stream<List<SceneObject>> worlds() {
        return Stream.of(List.of(CylinderLattice.DEFAULT), spheres(), hills());
    }

    /**
     * What a lamp at rest sees of a thousand balls that pass is prepared, piece by piece: no tree is searched for it.
     */
    @Test
    void shadowsOfWhatPassesALampNeedNoNodes() throws InterruptedException {
        Studio paper = small(PaperStudios.fig1a());
        Velocity velocity = Velocity.of(0.5, 0, 0);
        Studio passing = Lighting.of(
                paper.withScene(List.of(new Moving("", velocity, new Vector3d(), 0, balls(1000, 0.05))))
                        .withCamera(paper.camera().withShutter(new AperturePlaneShutter(10))),
                List.of(lamp()));
        RenderReport report = report(passing);

        assertThat(report.counts().shadowRays).isGreaterThan(5_000);
        assertThat(report.counts().nodes).isZero();
        assertThat(report.counts().tests).isLessThanOrEqualTo(13_569);
    }

    private static LightSource lamp() {
        return new PointLight(new Vector3d(5, 10, -5), Colour.grey(0.7), Colour.BLACK, 1);
    }

    private static RenderReport report(Studio studio) throws InterruptedException {
        try (Renderer renderer = new Renderer(2)) {
            return renderer.render(RenderPlan.of(studio)).report();
        }
    }

    private static Studio small(Studio studio) {
        return studio.withSettings(studio.settings().withSize(160, 120));
    }

    /** Triangles as small as pixels, of which a block of rays meets too many. */
    private static List<SceneObject> hills() {
        List<SceneObject> triangles = new ArrayList<>();
        for (int column = 0; column < 300; column++) {
            for (int row = 0; row < 300; row++) {
                Vector3d right = hill(column + 1, row);
                Vector3d below = hill(column, row + 1);
                triangles.add(new Triangle("", hill(column, row), below, right, ColouredSurface.DEFAULT));
                triangles.add(new Triangle("", hill(column + 1, row + 1), right, below, ColouredSurface.DEFAULT));
            }
        }
        return triangles;
    }

    private static Vector3d hill(int column, int row) {
        double x = column / 50.0 - 3;
        double y = row / 50.0 - 3;
        return new Vector3d(x, y, 10 + 0.3 * Math.sin(5 * x) * Math.cos(5 * y));
    }

    /** A field of so many spheres that a block of rays meets more than a few, and so many that a lamp does. */
    private static List<SceneObject> spheres() {
        return balls(30_000, 0.02);
    }

    private static List<SceneObject> balls(int count, double radius) {
        Random random = new Random(count);
        return IntStream.range(0, count)
                .<SceneObject>mapToObj(i -> new Sphere(
                        "sphere",
                        new Vector3d(random.nextDouble(-2, 2), random.nextDouble(-1.5, 1.5), random.nextDouble(8, 12)),
                        radius,
                        ColouredSurface.DEFAULT))
                .toList();
    }

    /**
     * A figure of the paper; a wall, seen by a camera that moves through water; and thin spokes that turn, where most
     * rays are searched for as curves and meet none, because a hit takes memory of its own.
     */
    static Stream<Studio> studios() {
        Studio water = Studio.DEFAULT
                .withScene(List.of(
                        new Sphere("water", new Vector3d(), 30, new Refractive(1.33)),
                        new Plane("wall", new Vector3d(0, 0, 5), new Vector3d(0, 0, -1), ColouredSurface.DEFAULT)))
                .withVelocity(Velocity.of(new Vector3d(0, 0, 0.5)));
        List<SceneObject> spokes = IntStream.range(0, 12)
                .mapToDouble(spoke -> Math.PI * spoke / 6)
                .<SceneObject>mapToObj(angle -> new Cylinder(
                        "spoke",
                        new Vector3d(0, 0, 10),
                        new Vector3d(2 * Math.cos(angle), 2 * Math.sin(angle), 10),
                        0.01,
                        true,
                        new LuminousSurface(Colour.WHITE, true)))
                .toList();
        Studio wheel = Studio.DEFAULT.withScene(
                List.of(new Rotating("wheel", new Vector3d(0, 0, 10), new Vector3d(0, 0, 1), 0.4, 0, spokes)));
        return Stream.of(PaperStudios.fig1b(), water, wheel);
    }

    /** Once compiled: about 20 bytes, more where the compiler has seen other scenes before. */
    @ParameterizedTest(name = "{index}")
    @MethodSource("studios")
    void aSampleAllocatesLittle(Studio studio) {
        assertThat(bytesOfASample(studio)).isLessThanOrEqualTo(BYTES_PER_SAMPLE);
    }

    private static long bytesOfASample(Studio studio) {
        RayCounts counts = new RayCounts();
        RenderPlan plan = RenderPlan.of(studio);
        SampleTracer tracer = plan.tracer(counts);
        SamplePositions places = new SamplePositions(RayPacket.MOST);
        EyeView eye = plan.pictureRays().views().get(0);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long least = Long.MAX_VALUE;
        // what is compiled later allocates less: on a busy machine the compiler needs longer
        for (int picture = 0; picture < 20 && least > BYTES_PER_SAMPLE; picture++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            takeAll(tracer, studio, eye, places);
            least = Math.min(least, (threads.getCurrentThreadAllocatedBytes() - before) / (640 * 480));

            assertThat(counts.samples).isEqualTo((picture + 1) * 640 * 480);
        }
        return least;
    }

    private static void takeAll(SampleTracer tracer, Studio studio, EyeView eye, SamplePositions places) {
        int side = RayPacket.SIDE;
        for (int row = 0; row < studio.settings().height(); row += side) {
            for (int column = 0; column < studio.settings().width(); column += side) {
                places.begin(eye);
                places.addPixels(column, row, side, side, 1, (x, y) -> true);
                tracer.sampleBlock(places, 0, () -> false);
            }
        }
    }

    private static Studio samples(Studio studio, int samples) {
        return studio.withSettings(studio.settings().withSamples(samples));
    }
}
