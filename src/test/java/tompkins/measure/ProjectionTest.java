package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.Camera;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.ArbitraryPlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.world.FrameAppearance;

/** Places by formulas, against traced rays: a point on the ray of a place is projected to that place again. */
class ProjectionTest {

    private static final FrameMotion MOTION =
            new FrameMotion(null, Velocity.of(0.3, 0.5, -0.2), new Event(0.1, -0.2, 0.4, 0));

    static Stream<Arguments> cameras() {
        List<Velocity> velocities =
                List.of(Velocity.of(0.3, -0.2, 0.6), Velocity.of(0, 0.1, -0.5), Velocity.of(0.2, -0.1, 0.97));
        List<Shutter> shutters = List.of(
                new AperturePlaneShutter(0.7),
                new DetectorPlaneShutter(0.3, 2),
                new ArbitraryPlaneShutter(0.2, new Vector3d(0, 0, 3), new Vector3d(0.1, 0.2, 1)));
        ThinLensCamera lens = Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d(0.4, 0.3, -0.6));
        PanoramicCamera panorama = Descriptions.with(PanoramicCamera.DEFAULT, "position", new Vector3d(0.4, 0.3, -0.6));
        return velocities.stream()
                .flatMap(velocity -> shutters.stream()
                        .flatMap(shutter -> Stream.of((Camera) lens, panorama)
                                .flatMap(camera -> Stream.of(
                                                RollingShutter.DEFAULT, new RollingShutter(SweepDirection.UP, 0.05))
                                        .map(rolling -> Arguments.of(
                                                velocity,
                                                Descriptions.with(
                                                        camera.withShutter(shutter), "rollingShutter", rolling))))));
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void pointIsProjectedToWhereItsRayCameFrom(Velocity velocity, Camera camera) {
        for (View view : View.values()) {
            for (TransformationLaw law : TransformationLaw.values()) {
                Studio studio = Studio.DEFAULT
                        .withCamera(camera)
                        .withVelocity(velocity)
                        .withView(view)
                        .withTransformation(law);
                check(studio, null);
                boolean slowerThanLight =
                        velocity.components().distance(MOTION.velocity().components()) < 1;
                if (law == TransformationLaw.LORENTZ || law == TransformationLaw.GALILEAN && slowerThanLight) {
                    check(studio, MOTION);
                }
            }
        }
    }

    private static void check(Studio studio, FrameMotion motion) {
        Projection projection = Projection.of(studio);
        FrameAppearance frame = new FrameAppearance(studio, motion);
        RenderPlan plan = RenderPlan.of(studio);
        boolean rolls = studio.camera().rollingShutter().rolls();
        int found = 0;
        int again = 0;
        for (int i = 0; i < 5; i++) {
            double x = Math.floor(studio.settings().width() * (0.15 + 0.17 * i)) + 0.4;
            double y = Math.floor(studio.settings().height() * (0.85 - 0.15 * i)) + 0.6;
            for (double distance : new double[] {2, 30}) {
                Vector3d point = point(plan, motion, x, y, distance);
                Vector2dc place = projection.position(frame, point);
                if (place != null && isInside(studio, place)) {
                    found++;
                    assertThat(miss(plan, motion, place, point, distance))
                            .as(
                                    "%s %s %s %s: %s, %s is seen at %s",
                                    studio.view(), studio.transformation(), motion != null, distance, x, y, place)
                            .isLessThan(rolls ? 0.2 * projection.pixelAngle(x, y) : 1e-6);
                    again += place.distance(x, y) < 0.01 ? 1 : 0;
                }
            }
        }
        assertThat(found)
                .as("%s %s %s", studio.view(), studio.transformation(), motion != null)
                .isGreaterThan(7);
        boolean oneTime = studio.camera().shutter() instanceof AperturePlaneShutter && !rolls;
        // fast things are seen more than once by a shutter that takes its time
        assertThat(again)
                .as("%s %s %s of %s", studio.view(), studio.transformation(), motion != null, found)
                .isGreaterThanOrEqualTo(oneTime ? found : 1);
    }

    private static boolean isInside(Studio studio, Vector2dc place) {
        return place.x() > 0
                && place.y() > 0
                && place.x() < studio.settings().width()
                && place.y() < studio.settings().height();
    }

    /** By which angle, in the frame of a point, the traced ray of a place misses it. */
    private static double miss(RenderPlan plan, FrameMotion motion, Vector2dc place, Vector3d point, double distance) {
        Vector3d near = point(plan, motion, place.x(), place.y(), 0);
        Vector3d far = point(plan, motion, place.x(), place.y(), distance);
        return Angles.between(far.sub(near), point.sub(near, new Vector3d()));
    }

    /** Where, in its rest frame, a point is that the traced ray of a place meets at a distance. */
    static Vector3d point(RenderPlan plan, FrameMotion motion, double x, double y, double distance) {
        SampleHistory life = SampleHistory.of(plan, x, y, 0, 0);
        Event start = life.sceneStart();
        Vector3d place = new Vector3d(life.sceneDirection()).mul(distance).add(start.position());
        Event event = new Event(place.x, place.y, place.z, start.time() - distance * life.lastSlowness());
        return motion == null
                ? place
                : plan.studio()
                        .transformation()
                        .sceneFromCamera(motion.velocity())
                        .inverse()
                        .transform(event.minus(motion.start()))
                        .position();
    }

    @Test
    void directionsBehindALensHaveNoPlace() {
        Projection projection = Projection.of(Studio.DEFAULT);

        assertThat(projection.position(new Vector3d(0, 0, -1))).isNull();
        assertThat(projection.position(new FrameAppearance(Studio.DEFAULT, null), new Vector3d(0, 0, -5)))
                .isNull();
        assertThat(projection.position(new FrameAppearance(Studio.DEFAULT, null), new Vector3d()))
                .isNull();
    }
}
