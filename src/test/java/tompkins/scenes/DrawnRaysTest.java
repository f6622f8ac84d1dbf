package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tompkins.camera.ThinLensCamera;
import tompkins.measure.RayTubes;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

class DrawnRaysTest {

    private static final Studio SCENE = SceneFiles.read("rays-burning-glass");
    private static final int LAST = SCENE.scene().size() - 1;

    private static List<Group> rays(Studio studio) {
        return ((Group) studio.scene().get(LAST))
                .objects().stream().map(Group.class::cast).toList();
    }

    /** The way of the main branch, from the lens to the screen. */
    private static List<Cylinder> main(Group ray) {
        SceneObject last = ray.objects().stream()
                .filter(part -> part.description().equals("hit on screen"))
                .findFirst()
                .orElseThrow();
        return ray.objects().stream()
                .filter(Cylinder.class::isInstance)
                .map(Cylinder.class::cast)
                .filter(rod -> Objects.equals(rod.surface(), ((Sphere) last).surface()))
                .toList();
    }

    /** Where a ray crosses the axis behind the lens. */
    private static double crossing(Group ray) {
        List<Cylinder> rods = main(ray);
        Cylinder out = rods.get(rods.size() - 1);
        double slope =
                (out.end().y() - out.start().y()) / (out.end().z() - out.start().z());
        return out.start().z() - out.start().y() / slope;
    }

    @Test
    void theSceneHoldsWhatTheProgramDraws() {
        Studio before = SCENE.withScene(SCENE.scene().subList(0, LAST))
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", 30.0))
                .withSettings(SCENE.settings().withSize(401, 301));
        RenderPlan plan = RenderPlan.of(before);
        List<SampleHistory> lives = IntStream.of(30, 90, 150, 210, 270)
                .mapToObj(row -> SampleHistory.of(plan, 200.5, row + 0.5, 0, 0))
                .toList();

        List<Group> drawn = rays(RayTubes.addedTo(before, "rays", lives));

        for (int i = 0; i < drawn.size(); i++) {
            List<SceneObject> expected = drawn.get(i).objects();
            List<SceneObject> found = rays(SCENE).get(i).objects();
            assertThat(found).hasSameSizeAs(expected);
            for (int k = 0; k < found.size(); k++) {
                assertThat(found.get(k).description()).isEqualTo(expected.get(k).description());
                if (found.get(k) instanceof Sphere ball) {
                    assertThat(ball.centre().distance(((Sphere) expected.get(k)).centre()))
                            .isLessThan(1e-12);
                }
            }
        }
    }

    /** Spheres bend what passes near their edge too strongly; the image on the axis lies near the screen at 12. */
    @Test
    void outerRaysMeetBeforeTheScreen() {
        List<Group> rays = rays(SCENE);
        assertThat(rays).hasSize(5);
        assertThat(crossing(rays.get(0))).isCloseTo(crossing(rays.get(4)), within(1e-9));
        assertThat(crossing(rays.get(1))).isBetween(11.4, 12.0);
        assertThat(crossing(rays.get(1)) - crossing(rays.get(0))).isGreaterThan(0.3);
    }
}
