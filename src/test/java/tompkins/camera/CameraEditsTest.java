package tompkins.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.math.RigidMotion;
import tompkins.property.Descriptions;
import tompkins.shutter.ArbitraryPlaneShutter;
import tompkins.spacetime.IdentityTransformation;

/** Every kind of camera can be moved, turned, zoomed and focused. */
class CameraEditsTest {

    private static final Offset<Double> EXACT = within(1e-12);
    private static final Vector3dc DIRECTION = new Vector3d(0.28, 0, 0.96);

    static Stream<Camera> cameras() {
        Stream<Camera> usual =
                Descriptions.members(Camera.class).stream().map(type -> (Camera) Descriptions.standard(type));
        return Stream.concat(usual, Stream.of(FocusDistance.with(ThinLensCamera.DEFAULT, 10)))
                .map(camera -> camera.withShutter(
                        new ArbitraryPlaneShutter(1, new Vector3d(0.2, 0, 3), new Vector3d(0.1, 0, 1))));
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void focusIsReadAndSet(Camera camera) {
        assertThat(FocusDistance.of(camera)).isCloseTo(10, EXACT);
        Camera near = FocusDistance.with(camera, 4);
        assertThat(FocusDistance.of(near)).isCloseTo(4, EXACT);
        assertThat(near.shutter()).isEqualTo(camera.shutter());
        assertThat(FocusDistance.toPoint(camera, new Vector3d(0, 0, 6))).isCloseTo(6, EXACT);
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void pixelsKeepTheirShapeInAnotherFieldOfView(Camera camera) {
        Camera narrow = FieldOfView.with(camera, 12);
        assertThat(narrow.horizontalAngleDegrees()).isEqualTo(12);
        CameraRays rays = narrow.rays(100, 50, new IdentityTransformation());
        double right = rays.chiefDirection(51, 25).angle(rays.chiefDirection(50, 25));
        double up = rays.chiefDirection(50, 24).angle(rays.chiefDirection(50, 25));
        assertThat(up).isCloseTo(right, EXACT);
    }

    /**
     * Shutter and focus go along, so that the light through the lens in a turned direction crosses at the same time.
     */
    @ParameterizedTest
    @MethodSource("cameras")
    void whatBelongsToTheCameraGoesAlong(Camera camera) {
        RigidMotion motion = new RigidMotion(new Quaterniond().rotateXYZ(0.3, -1.1, 2), new Vector3d(5, -6, 7));
        Camera moved = CameraMotion.moved(camera, motion);
        assertThat(moved.position().distance(5, -6, 7)).isLessThan(1e-12);
        assertThat(time(moved, motion.direction(DIRECTION))).isCloseTo(time(camera, DIRECTION), EXACT);
        assertThat(FocusDistance.of(moved)).isCloseTo(10, EXACT);
        RigidMotion back = CameraMotion.between(moved, camera);
        assertThat(CameraMotion.moved(moved, back).viewDirection().distance(camera.viewDirection()))
                .isLessThan(1e-12);
        Camera turned = CameraMotion.turned(camera, new Vector3d(1, 0, 0), new Vector3d(0, 1, 0));
        assertThat(time(turned, new Vector3d(0.96, 0, -0.28))).isCloseTo(time(camera, DIRECTION), EXACT);
    }

    private static double time(Camera camera, Vector3dc direction) {
        CameraRays rays = camera.rays(640, 480, new IdentityTransformation());
        return camera.shutter().transmissionTime(rays.chiefRay(direction), new IdentityTransformation());
    }
}
