package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.sceneobject.Hidden;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.ColouredSurface;
import tompkins.trace.RenderPlan;

/**
 * A picture without any of the objects of its scene says so. At beta across the view the ray of the middle comes from
 * (-beta, 0, 1 / gamma): the formula of aberration for 90 degrees in the camera frame.
 */
class MissedSceneTest {

    private static final String WARNING =
            "no ray met an object of the scene: another direction, a wider field of view or a lower speed may show some";

    private static final Vector3dc AHEAD = new Vector3d(0, 0, 6);

    private static SceneObject sphere(Vector3dc centre) {
        return new Sphere("sphere", centre, 1, Photograph.WHITE);
    }

    private static List<String> warnings(double beta, SceneObject... scene) {
        return Photograph.of(
                        List.of(scene),
                        Photograph.pinhole(new Vector3d(0, 0, 1), 20, 0),
                        Velocity.of(beta, 0, 0),
                        16,
                        12)
                .job()
                .report()
                .warnings();
    }

    @Test
    void whatIsAheadIsMissedAtSpeedAndWhatIsBehindIsSeen() {
        assertThat(warnings(0, sphere(AHEAD))).isEmpty();
        assertThat(warnings(0.8, sphere(AHEAD))).containsExactly(WARNING);
        assertThat(warnings(0.8, sphere(new Vector3d(-0.8, 0, 0.6).mul(6)))).isEmpty();
        assertThat(warnings(0.8, sphere(AHEAD), sphere(new Vector3d(-0.8, 0, 0.6).mul(6))))
                .isEmpty();
    }

    @Test
    void aSceneInWhichNothingCanBeMetMissesNothing() {
        assertThat(warnings(0.8)).isEmpty();
        assertThat(warnings(0.8, new Hidden(sphere(AHEAD)))).isEmpty();
    }

    /** A flash of a ten thousandth of the exposure, which none of 16 samples meets. */
    @Test
    void aFlashThatIsMissedBlamesTheExposure() throws InterruptedException {
        PointLight lamp = new PointLight(new Vector3d(0, 0, -1), Colour.WHITE, Colour.BLACK, 1, new Pulse(0, 1e-3, 0));
        Studio studio = Lighting.of(Studios.dark(), List.of(lamp))
                .withScene(List.of(new Sphere("sphere", AHEAD, 1, ColouredSurface.DEFAULT)))
                .withSettings(RenderSettings.DEFAULT.withSize(2, 2));
        try (Renderer renderer = new Renderer(1)) {
            RenderPlan plan = RenderPlan.of(studio.withCamera(Descriptions.with(studio.camera(), "exposureTime", 10.0)
                    .withShutter(new AperturePlaneShutter(5.5))));
            assertThat(renderer.render(plan, new Quality.Samples(16)).report().warnings())
                    .singleElement()
                    .asString()
                    .contains("short part of it takes more samples, or a shorter exposureTime");
        }
    }
}
