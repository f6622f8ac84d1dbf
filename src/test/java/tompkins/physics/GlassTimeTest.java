package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.ThinLensCamera;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.Event;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Refractive;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/** Light in glass of index n needs n times as long, which matters when the glass moves with the camera. */
class GlassTimeTest {

    /** From 2 to 4 in front of the lens. */
    private static final Box SLAB =
            new Box("slab", new Vector3d(-50, -50, 2), new Vector3d(50, 50, 4), new Refractive(1.5));

    private static final SceneObject WALL =
            new Plane("wall", new Vector3d(0, 0, 30), new Vector3d(0, 0, -1), ColouredSurface.DEFAULT);

    private static RayLife life(Velocity velocity, double x) {
        Studio studio = Studio.DEFAULT
                .withScene(List.of(WALL))
                .withCameraFrame(List.of(SLAB))
                .withCamera(ThinLensCamera.DEFAULT)
                .withVelocity(velocity)
                .withSettings(Studio.DEFAULT.settings().withSize(100, 100));
        return RayLife.of(RenderPlan.of(studio), x, 50, 0, 0);
    }

    /** The event on the way straight through, not on that of a reflection. */
    private static Event leavesTheGlass(RayLife life) {
        return life.hits().stream()
                .map(RayLife.Encounter::event)
                .filter(event -> Math.abs(event.z() - 4) < 1e-9)
                .max((one, other) -> Double.compare(one.time(), other.time()))
                .orElseThrow();
    }

    @Test
    void lightThroughAMovingSlabComesFromAnEarlierPlace() {
        RayLife life = life(Velocity.of(0, 0, 0.8), 50);
        // 2 to the glass, 1.5 times 2 in it
        assertThat(leavesTheGlass(life).time()).isCloseTo(-5, within(1e-12));
        // gamma = 5/3: z = gamma (4 - 0.8 times 5) = 0 at the time gamma (-5 + 0.8 times 4) = -3, and 30 to go
        assertThat(life.hits())
                .filteredOn(hit -> hit.object().equals("wall"))
                .anySatisfy(hit -> assertThat(hit.event().time()).isCloseTo(-33, within(1e-12)));
    }

    @Test
    void aSlantingRayNeedsTheTimeOfItsPathByTheLawOfSnell() {
        RayLife life = life(Velocity.REST, 90);
        Vector3d direction = new Vector3d(life.cameraDirection());
        double sine = direction.x / 1.5;
        double pathInGlass = 2 / Math.sqrt(1 - sine * sine);
        Event leaves = leavesTheGlass(life);
        assertThat(direction.x).isGreaterThan(0.1);
        assertThat(leaves.time()).isCloseTo(-2 / direction.z - 1.5 * pathInGlass, within(1e-12));
        assertThat(leaves.x()).isCloseTo(2 * direction.x / direction.z + sine * pathInGlass, within(1e-12));
    }
}
