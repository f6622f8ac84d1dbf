package tompkins.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.Camera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.surface.LorentzWindow;
import tompkins.surface.WindowAxes;

class FrontWindowTest {

    private static final Velocity FAST = Velocity.of(0.1, 0, 0.9);
    private static final LorentzWindow CLEAR = new LorentzWindow(FAST, WindowAxes.FRAME, 1);

    @Test
    void theWindowStandsInFrontOfTheLens() {
        Studio studio = FrontWindow.with(Studios.sphere(), CLEAR);
        assertThat(studio.cameraFrame())
                .containsExactly(
                        new Plane(FrontWindow.DESCRIPTION, new Vector3d(0, 0, 0.01), new Vector3d(0, 0, 1), CLEAR));
        assertThat(FrontWindow.of(studio)).contains(CLEAR);
        assertThat(FrontWindow.with(studio, null).cameraFrame()).isEmpty();
    }

    @Test
    void otherThingsThatMoveWithTheCameraStay() {
        Studio studio = Studios.sphere().withCameraFrame(List.of(Sphere.DEFAULT));
        assertThat(FrontWindow.with(FrontWindow.with(studio, CLEAR), null)).isEqualTo(studio);
    }

    @Test
    void aMatchingWindowFollowsTheCamera() {
        Studio studio = FrontWindow.with(Studios.sphere().withVelocity(FAST), CLEAR);
        Velocity faster = Velocity.of(0, 0, 0.99);
        Studio moved = FrontWindow.withVelocity(studio, faster);
        assertThat(moved.velocity()).isEqualTo(faster);
        assertThat(FrontWindow.matches(moved)).isTrue();
        Studio free = FrontWindow.withVelocity(FrontWindow.with(studio.withVelocity(Velocity.REST), CLEAR), faster);
        assertThat(FrontWindow.of(free)).contains(CLEAR);
    }

    @Test
    void aWindowOfAnyShapeIsOne() {
        Parallelogram sheet = Descriptions.with(Parallelogram.DEFAULT, "surface", CLEAR);
        Studio studio = Studios.sphere().withVelocity(FAST).withCameraFrame(List.of(Sphere.DEFAULT, sheet));
        assertThat(FrontWindow.of(studio)).contains(CLEAR);
        Velocity slow = Velocity.of(0, 0, 0.1);
        assertThat(FrontWindow.withVelocity(studio, slow).cameraFrame())
                .containsExactly(
                        Sphere.DEFAULT,
                        Descriptions.with(sheet, "surface", new LorentzWindow(slow, WindowAxes.FRAME, 1)));
        assertThat(FrontWindow.with(studio, null).cameraFrame()).containsExactly(Sphere.DEFAULT);
    }

    /** As when a form changes the whole studio at once. */
    @Test
    void aWindowThatWasChangedItselfDoesNotFollow() {
        Studio studio = FrontWindow.with(Studios.sphere().withVelocity(FAST), CLEAR);
        Velocity slow = Velocity.of(0, 0, 0.1);
        LorentzWindow other = new LorentzWindow(Velocity.of(0, 0.2, 0), WindowAxes.FRAME, 1);
        assertThat(FrontWindow.matches(FrontWindow.following(studio, studio.withVelocity(slow))))
                .isTrue();
        assertThat(FrontWindow.of(FrontWindow.following(studio, FrontWindow.with(studio.withVelocity(slow), other))))
                .contains(other);
    }

    @Test
    void theWindowGoesWhereTheLensIs() {
        Studio studio = Studios.sphere();
        Camera camera = Descriptions.with(studio.camera(), "position", new Vector3d(1, 2, 3));
        Camera far = Descriptions.with(camera, "viewDirection", new Vector3d(1e200, 0, 0));
        assertThat(FrontWindow.with(studio.withCamera(far), CLEAR).cameraFrame())
                .containsExactly(
                        new Plane(FrontWindow.DESCRIPTION, new Vector3d(1.01, 2, 3), new Vector3d(1, 0, 0), CLEAR));
    }
}
