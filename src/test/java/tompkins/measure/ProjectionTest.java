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
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
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
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;

/** Places by formulas, against rays that are traced to tiny balls: they are hit there, and nowhere beside it. */
class ProjectionTest {

    private static final FrameMotion MOTION =
            new FrameMotion(null, Velocity.of(0.3, 0.5, -0.2), new Event(0.1, -0.2, 0.4, 0));

    static Stream<Arguments> cameras() {
        List<Velocity> velocities = List.of(Velocity.of(0.3, -0.2, 0.6), Velocity.of(0, 0.1, -0.5), Velocity.of(0.2, -0.1, 0.97));
        List<Shutter> shutters = List.of(
                new AperturePlaneShutter(0.7),
                new DetectorPlaneShutter(0.3, 2),
                new ArbitraryPlaneShutter(0.2, new Vector3d(0, 0, 3), new Vector3d(0.1, 0.2, 1)));
        ThinLensCamera lens = Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d(0.4, 0.3, -0.6));
        PanoramicCamera panorama = Descriptions.with(PanoramicCamera.DEFAULT, "position", new Vector3d(0.4, 0.3, -0.6));
        return velocities.stream()
                .flatMap(velocity -> shutters.stream()
                        .flatMap(shutter -> Stream.of((Camera) lens, panorama)
                                .flatMap(camera -> Stream.of(RollingShutter.DEFAULT, new RollingShutter(SweepDirection.UP, 0.5))
                                        .map(rolling -> Arguments.of(
                                                velocity, camera.withShutter(shutter).withRollingShutter(rolling))))));
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void ballIsHitWhereItIsProjected(Velocity velocity, Camera camera) {
        for (View view : View.values()) {
            for (TransformationLaw law : TransformationLaw.values()) {
                Studio studio = Studio.DEFAULT
                        .withCamera(camera)
                        .withVelocity(velocity)
                        .withView(view)
                        .withTransformation(law);
                for (FrameMotion motion : new FrameMotion[] {null, MOTION}) {
                    check(studio, law == TransformationLaw.NONE ? null : motion);
                }
            }
        }
    }

    private static void check(Studio studio, FrameMotion motion) {
        Projection projection = Projection.of(studio);
        SeenFrame frame = new SeenFrame(studio, motion);
        int inPicture = 0;
        for (int i = 0; i < 5; i++) {
            Vector3d target = target(projection, frame, studio, i);
            Vector2dc place = projection.place(frame, target);
            if (place == null) {
                continue;
            }
            boolean inside = place.x() > 1 && place.y() > 1 && place.x() < projection.width() - 1 && place.y() < projection.height() - 1;
            if (!inside) {
                continue;
            }
            inPicture++;
            double distance = target.distance(frame.fromCamera(projection.lensEvent()).position());
            assertHit(studio, motion, target, distance, place);
        }
        assertThat(inPicture).as("%s", studio.camera()).isPositive();
    }

    /** A point that is about in the direction of some place of the picture. */
    private static Vector3d target(Projection projection, SeenFrame frame, Studio studio, int number) {
        double x = projection.width() * (0.15 + 0.17 * number);
        double y = projection.height() * (0.85 - 0.15 * number);
        Vector3d wanted = new Vector3d(projection.direction(x, y));
        Event lens = frame.fromCamera(projection.lensEvent());
        Vector3d best = new Vector3d();
        double least = 10;
        // the direction of the frame that is seen nearest to it, out of many
        for (int i = 0; i < 20_000; i++) {
            double z = 1 - (2 * i + 1) / 20_000.0;
            double turn = i * 2.399963229728653;
            Vector3d direction = new Vector3d(
                    Math.sqrt(1 - z * z) * Math.cos(turn), Math.sqrt(1 - z * z) * Math.sin(turn), z);
            Vector3d seen = frame.look(direction);
            double angle = seen == null ? 10 : Angles.between(seen, wanted);
            if (angle < least) {
                least = angle;
                best = direction;
            }
        }
        return best.mul(3 + number).add(lens.position());
    }

    private static void assertHit(Studio studio, FrameMotion motion, Vector3d target, double distance, Vector2dc place) {
        SceneObject ball = new Sphere("ball", target, distance * 1e-4, LuminousSurface.DEFAULT);
        SceneObject placed = motion == null
                ? ball
                : new Moving("", motion.velocity(), motion.start().position(), 0, List.of(ball));
        RenderPlan plan = RenderPlan.of(studio.withScene(List.of(placed)));
        assertThat(Sighting.of(plan, place.x(), place.y()).hit())
                .as("%s %s", studio, place)
                .isNotNull();
    }

    @Test
    void directionsBehindALensHaveNoPlace() {
        Projection projection = Projection.of(Studio.DEFAULT);

        assertThat(projection.place(new Vector3d(0, 0, -1))).isNull();
        assertThat(projection.place(new SeenFrame(Studio.DEFAULT, null), new Vector3d(0, 0, -5))).isNull();
        assertThat(projection.place(new SeenFrame(Studio.DEFAULT, null), new Vector3d())).isNull();
    }
}
