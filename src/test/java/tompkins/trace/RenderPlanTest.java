package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector2i;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.Camera;
import tompkins.camera.FieldOfView;
import tompkins.explain.Explanation;
import tompkins.light.ColourLaw;
import tompkins.primitive.Bounds;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.Velocity;
import tompkins.studio.LensEvent;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;

/** What a plan takes from its studio, and what it takes over from another plan. */
class RenderPlanTest {

    /** 60 degrees wide, 64 x 48 pixels; gamma is 1.25. */
    private static final Studio MOVING = Studio.DEFAULT
            .withScene(List.of(Sphere.DEFAULT))
            .withVelocity(Velocity.of(0, 0, 0.6))
            .withCamera(FieldOfView.with(Studio.DEFAULT.camera(), 60))
            .withSettings(Studio.DEFAULT.settings().withSize(64, 48));

    @Test
    void sceneIsTakenOverWhileItStays() {
        RenderPlan before = RenderPlan.of(MOVING);

        assertThat(RenderPlan.of(MOVING.withVelocity(Velocity.of(0.1, 0, 0)), before)
                        .world()
                        .frames())
                .isSameAs(before.world().frames());
        assertThat(RenderPlan.of(MOVING.withScene(List.of(Box.DEFAULT)), before)
                        .world()
                        .frames())
                .isNotSameAs(before.world().frames());
    }

    /**
     * A point of the camera is photographed in the middle of exposure and sweep: at the time t = 2 + 0.5/2 + 3/2 - |p|
     * of the camera, and then it is at gamma (z + beta t) in the scene.
     */
    @ParameterizedTest
    @CsvSource({"0, 0", "0.5, 0", "0, 3", "0.5, 3"})
    void imagePointsAreThoseOfTheMiddleOfTheExposure(double exposure, double sweep) {
        // the middle of the only cell of the grid
        Vector3d point = new Vector3d(1, -2, 6);
        Sphere ball = new Sphere("ball", new Vector3d(), 0.25, ColouredSurface.DEFAULT);
        ImagePointGrid grid = new ImagePointGrid(
                "grid",
                ball,
                new Vector3d(0.5, -2.5, 6),
                new Vector3d(1, 0, 0),
                new Vector3d(0, 1, 0),
                new Vector2i(1, 1));
        Camera slow =
                Descriptions.with(MOVING.camera().withShutter(new AperturePlaneShutter(2)), "exposureTime", exposure);
        Camera camera = Descriptions.with(slow, "rollingShutter", new RollingShutter(SweepDirection.DOWN, sweep));

        List<Bounds> boxes = RenderPlan.of(MOVING.withScene(List.of(grid)).withCamera(camera))
                .sceneBounds(10);

        double time = 2 + exposure / 2 + sweep / 2 - point.length();
        Vector3d expected = new Vector3d(1, -2, 1.25 * (6 + 0.6 * time));
        assertThat(boxes).hasSize(1);
        assertThat(boxes.get(0).centre().distance(expected)).isLessThan(1e-12);
    }

    /** At unit distance behind the lens, light of the middle crosses it one time unit before the shutter opens. */
    @Test
    void lensIsWhereTheMiddleOfThePictureIsTaken() {
        Studio studio = MOVING.withCamera(MOVING.camera().withShutter(new DetectorPlaneShutter(5, 1)));

        assertThat(LensEvent.inScene(studio).time()).isCloseTo(1.25 * 4, within(1e-12));
        assertThat(LensEvent.inScene(studio).position().z()).isCloseTo(0.75 * 4, within(1e-12));
    }

    /** What stands before the lens hides the light that is metered, and does not change the exposure: D is 2 ahead. */
    @Test
    void lightIsMeteredAsIfNothingStoodBeforeTheLens() {
        Studio hidden = MOVING.withColours(ColourLaw.DOPPLER)
                .withCameraFrame(List.of(new Sphere("cap", new Vector3d(0, 0, 2), 0.5, ColouredSurface.DEFAULT)));

        assertThat(new Explanation(RenderPlan.of(hidden)).sentences())
                .anyMatch(sentence -> sentence.contains("where D is 2:"));
        assertThat(RenderPlan.of(hidden).isTooFaint()).isFalse();
        assertThat(RenderPlan.of(hidden.withVelocity(Velocity.of(0, 0, -0.99))).isTooFaint())
                .isTrue();
        assertThat(RenderPlan.of(MOVING).isTooFaint()).isFalse();
    }
}
