package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.camera.CameraMotion;
import tompkins.camera.SamplePositions;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;

/** A camera that moves through a ball of glass at rest, in whose middle it is at time 0. */
class MovingMediumTest {

    private static final double RADIUS = 3;
    private static final double INDEX = 1.5;

    private static RenderPlan plan(TransformationLaw law, Vector3dc velocity, Vector3d view) {
        Studio studio = Studio.DEFAULT
                .withScene(List.of(new Sphere("glass", new Vector3d(), RADIUS, new Refractive(INDEX))))
                .withTransformation(law)
                .withVelocity(Velocity.of(velocity))
                .withSettings(Studio.DEFAULT.settings().withSize(1, 1));
        return RenderPlan.of(studio.withCamera(CameraMotion.turned(studio.camera(), view, new Vector3d(0, 1, 0))));
    }

    /** In the glass light has the speed 1/n, whatever the camera does: it has left the edge 3 n before. */
    @ParameterizedTest
    @EnumSource(
            value = TransformationLaw.class,
            names = {"LORENTZ", "GALILEAN"})
    void lightOfTheEdgeComesThroughGlass(TransformationLaw law) {
        for (Vector3d view : List.of(new Vector3d(0, 0, 1), new Vector3d(1, 0, 0), new Vector3d(-2, 0.5, -1))) {
            SampleHistory.Encounter edge = SampleHistory.of(
                            plan(law, new Vector3d(0.2, 0.1, 0.5), view), 0.5, 0.5, 0, 0)
                    .mainHits()
                    .get(0);

            assertThat(edge.event().position().length()).isCloseTo(RADIUS, within(1e-12));
            assertThat(edge.event().time()).isCloseTo(-RADIUS * INDEX, within(1e-12));
        }
    }

    /** To a mirror 1 before the lens that moves with it, back to the lens, and 3 to the edge behind it. */
    @ParameterizedTest
    @EnumSource
    void aMirrorShowsWhatIsBehindACameraAtRest(TransformationLaw law) {
        Studio studio = plan(law, new Vector3d(), new Vector3d(0, 0, 1))
                .studio()
                .withCameraFrame(List.of(new Plane("", new Vector3d(0, 0, 1), new Vector3d(0, 0, -1), Mirror.DEFAULT)));
        SampleHistory life = SampleHistory.of(RenderPlan.of(studio), 0.5, 0.5, 0, 0);
        Event edge = life.mainHits().get(1).event();

        assertThat(edge.position().distance(new Vector3d(0, 0, -RADIUS))).isLessThan(1e-12);
        assertThat(edge.time()).isCloseTo(-(1 + 1 + RADIUS) * INDEX, within(1e-12));
    }

    /** Beside a cone the camera outruns all light, so that the last ray of the block has none. */
    @Test
    void aBlockThatEndsInDarknessIsThatOfItsSamples() {
        Studio studio = plan(TransformationLaw.LORENTZ, new Vector3d(0, 0, 0.9), new Vector3d(0.3, -0.3, 1))
                .studio();
        List<SceneObject> scene = new ArrayList<>(studio.scene());
        scene.add(new Plane("wall", new Vector3d(0, 0, 2), new Vector3d(0, 0, -1), ColouredSurface.DEFAULT));
        scene.add(new Moving("", Velocity.of(new Vector3d(0.5, 0, 0)), new Vector3d(), 0, List.of(Sphere.DEFAULT)));
        RenderPlan plan = RenderPlan.of(
                studio.withScene(scene).withSettings(studio.settings().withSize(RayPacket.SIDE, RayPacket.SIDE)));
        SampleTracer single = plan.tracer(new RayCounts());
        List<Colour> colours = new ArrayList<>();
        SamplePositions pixels = new SamplePositions(RayPacket.MOST);
        pixels.begin(plan.pictureRays().views().get(0));
        pixels.addPixels(0, 0, RayPacket.SIDE, RayPacket.SIDE, 1, (column, row) -> true);
        BlockSamples samples = plan.tracer(new RayCounts()).sampleBlock(pixels, 0, () -> false);
        for (int i = 0; i < pixels.count(); i++) {
            assertThat(samples.colour(i)).isEqualTo(single.sample(pixels.column(i), pixels.row(i), 0));
            colours.add(samples.colour(i));
        }

        assertThat(colours).hasSize(RayPacket.MOST).contains(Colour.BLACK).endsWith(Colour.BLACK);
        assertThat(Set.copyOf(colours)).hasSizeGreaterThan(10);
    }

    /**
     * What is seen across the motion was left behind by v t. Under Galileo t = -s with s = 1/sqrt(1/n^2 - v^2) for each
     * unit across. Under Lorentz lengths across stay, and s is 1/sqrt(1/n^2 - v^2) in the time of the scene.
     */
    @ParameterizedTest
    @CsvSource({"LORENTZ, 0.5", "GALILEAN, 0.5", "LORENTZ, -0.3", "GALILEAN, -0.3"})
    void whatIsSeenAcrossTheMotionLagsBehind(TransformationLaw law, double speed) {
        SampleHistory life =
                SampleHistory.of(plan(law, new Vector3d(0, 0, speed), new Vector3d(1, 0, 0)), 0.5, 0.5, 0, 0);
        double slowness = 1 / Math.sqrt(1 / (INDEX * INDEX) - speed * speed);
        Vector3d direction = new Vector3d(1, 0, -speed * slowness).normalize();

        assertThat(life.sceneDirection().distance(direction)).isLessThan(1e-12);
    }

    /** Light of the speed 2/3 does not reach a camera of the speed 0.9 from the side, nor from behind. */
    @Test
    void noLightComesFromWhereTheCameraOutrunsIt() {
        for (Vector3d view : List.of(new Vector3d(1, 0, 0), new Vector3d(0, 0, -1))) {
            RayCounts counts = new RayCounts();
            RenderPlan plan = plan(TransformationLaw.GALILEAN, new Vector3d(0, 0, 0.9), view);

            assertThat(plan.tracer(counts).sample(0.5, 0.5, 0, 0, 0.5)).isEqualTo(Colour.BLACK);
            assertThat(counts.notFinite).isZero();
        }
        SampleHistory ahead = SampleHistory.of(
                plan(TransformationLaw.GALILEAN, new Vector3d(0, 0, 0.9), new Vector3d(0, 0, 1)), 0.5, 0.5, 0, 0);
        assertThat(ahead.mainHits().get(0).event().time()).isCloseTo(-RADIUS * INDEX, within(1e-12));
    }
}
