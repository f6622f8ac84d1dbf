package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.Cameras;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.sceneobject.Plane;
import tompkins.studio.Studio;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/** Fig. 4 of the paper: a Lorentz window in front of the lens undoes the aberration. */
class LorentzWindowTest {

    private static final double TRANSMISSION = 0.96;

    @Test
    void windowAtThePinholeGivesTheDimmedRestPicture() throws InterruptedException {
        Studio figure = SceneFiles.read("fig4");
        Plane window = (Plane) figure.cameraFrame().get(0);
        Plane touching = new Plane(window.description(), new Vector3d(0, 0, 1e-13), window.normal(), window.surface());

        LinearImage moving = SceneFiles.render(figure.withCameraFrame(List.of(touching)));
        LinearImage resting = SceneFiles.render(SceneFiles.read("fig1a"));

        int differing = 0;
        for (int i = 0; i < moving.rgb().length; i++) {
            differing += Math.abs(moving.rgb()[i] - TRANSMISSION * resting.rgb()[i]) > 1e-6 ? 1 : 0;
        }
        // where an edge runs through the centre of a pixel, rounding decides
        assertThat(differing).isLessThanOrEqualTo(3);
    }

    @Test
    void windowAtADistanceOnlyShiftsThePointOfView() {
        Studio figure = SceneFiles.read("fig4");
        RenderPlan plan = RenderPlan.of(figure);
        for (int x = 7; x < 640; x += 37) {
            for (int y = 5; y < 480; y += 31) {
                RayLife seen = RayLife.of(plan, x + 0.5, y + 0.5, 0, 0);
                Vector3d turned = new Vector3d(seen.sceneDirection()).sub(seen.cameraDirection());
                assertThat(turned.length()).isLessThan(1e-13);

                RayLife shifted =
                        RayLife.of(RenderPlan.of(restingAt(seen.sceneStart().position())), x + 0.5, y + 0.5, 0, 0);
                assertThat(seen.colour().red())
                        .isCloseTo(TRANSMISSION * shifted.colour().red(), within(1e-9));
                assertThat(seen.colour().green())
                        .isCloseTo(TRANSMISSION * shifted.colour().green(), within(1e-9));
                assertThat(seen.colour().blue())
                        .isCloseTo(TRANSMISSION * shifted.colour().blue(), within(1e-9));
            }
        }
    }

    private static Studio restingAt(Vector3d position) {
        Studio resting = SceneFiles.read("fig1a");
        ThinLensCamera camera = (ThinLensCamera) resting.camera();
        return resting.withCamera(Cameras.lens(
                position,
                camera.viewDirection(),
                camera.topDirection(),
                camera.horizontalAngleDegrees(),
                camera.verticalAngleDegrees(),
                0,
                camera.focus(),
                0,
                camera.shutter()));
    }
}
