package tompkins.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.Aim.PicturePosition;
import tompkins.math.Vectors;
import tompkins.spacetime.IdentityTransformation;

class AimTest {

    private static final Offset<Double> EXACT = within(1e-12);

    static Stream<Camera> cameras() {
        Camera tilted =
                CameraMotion.turned(ThinLensCamera.DEFAULT, new Vector3d(0.3, -0.5, -1), new Vector3d(0.1, 1, 0.2));
        return Stream.of(
                ThinLensCamera.DEFAULT,
                tilted,
                FieldOfView.with(tilted, 110),
                PanoramicCamera.DEFAULT,
                CameraMotion.turned(PanoramicCamera.DEFAULT, new Vector3d(1, 0.2, 0), new Vector3d(0, 1, 0)));
    }

    private static PicturePosition place(double x, double y) {
        return new PicturePosition(x, y, 640, 480);
    }

    /** Turned by hand, a point stays under the mouse, and what is level stays level. */
    @ParameterizedTest
    @MethodSource("cameras")
    void whatIsDraggedStaysUnderTheMouse(Camera camera) {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 50; i++) {
            PicturePosition from = place(random.nextDouble(200, 440), random.nextDouble(180, 300));
            PicturePosition to = place(from.x() + random.nextDouble(-40, 40), from.y() + random.nextDouble(-20, 20));
            Vector3d seen = from.direction(camera);
            Camera now = Aim.at(camera, seen, to);
            assertThat(to.direction(now).distance(seen)).isLessThan(1e-12);
            assertThat(now.topDirection()).isEqualTo(camera.topDirection());
            assertThat(now.position()).isEqualTo(camera.position());
        }
    }

    @Test
    void nobodyLooksBeyondStraightUp() {
        Camera up = Aim.at(ThinLensCamera.DEFAULT, new Vector3d(0, 1, 0), place(320, 240));
        assertThat(Math.asin(Vectors.unit(up.viewDirection()).y())).isCloseTo(Aim.STEEPEST, EXACT);
        Camera still = Aim.at(up, PicturePosition.MIDDLE.direction(up), place(320, 400));
        assertThat(Math.asin(Vectors.unit(still.viewDirection()).y())).isCloseTo(Aim.STEEPEST, EXACT);
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void zoomsAboutAPlace(Camera camera) {
        PicturePosition place = place(400, 200);
        Vector3d seen = place.direction(camera);
        Camera narrow = Aim.zoomed(camera, 0.5, place);
        assertThat(narrow.horizontalAngleDegrees()).isCloseTo(camera.horizontalAngleDegrees() / 2, EXACT);
        assertThat(place.direction(narrow).distance(seen)).isLessThan(1e-12);
        assertThat(FieldOfView.zoomed(camera, 1e9).horizontalAngleDegrees())
                .isEqualTo(camera instanceof ThinLensCamera ? 170 : 360);
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void anglesBetweenTwoViewsLeadFromOneToTheOther(Camera camera) {
        Camera other = new Aim(-2.5, 0.3).turn(camera);
        Aim between = Aim.between(camera, other);
        assertThat(between.right()).isCloseTo(-2.5, EXACT);
        assertThat(between.up()).isCloseTo(0.3, EXACT);
        // a turn to the right of a level camera by a right angle looks along its right
        Camera level = ThinLensCamera.DEFAULT;
        assertThat(new Aim(Math.PI / 2, 0).turn(level).viewDirection().distance(level.rightDirection()))
                .isLessThan(1e-15);
        assertThat(new Aim(0, 0.4).turn(level).viewDirection().y()).isCloseTo(Math.sin(0.4), EXACT);
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void placesAndDirectionsAgree(Camera camera) {
        CameraRays rays = camera.rays(640, 480, new IdentityTransformation());
        for (double[] each : new double[][] {{320, 240}, {1, 2}, {600, 33}, {17, 477}}) {
            Vector2dc position = rays.position(rays.chiefDirection(each[0], each[1]));
            assertThat(position.distance(each[0], each[1])).isLessThan(1e-9);
        }
        Vector3dc behind = new Vector3d().sub(Vectors.unit(camera.viewDirection()));
        assertThat(rays.position(behind) == null).isEqualTo(camera instanceof ThinLensCamera);
    }
}
