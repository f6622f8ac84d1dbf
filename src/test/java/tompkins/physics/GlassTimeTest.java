package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.ThinLensCamera;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Refractive;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** Light in glass of index n needs n times as long, which matters when the glass moves with the camera. */
class GlassTimeTest {

    /** From 2 to 4 in front of the lens. */
    private static final Box SLAB =
            new Box("slab", new Vector3d(-50, -50, 2), new Vector3d(50, 50, 4), new Refractive(1.5));

    private static final SceneObject WALL =
            new Plane("wall", new Vector3d(0, 0, 30), new Vector3d(0, 0, -1), ColouredSurface.DEFAULT);

    private static SampleHistory life(Velocity velocity, double x) {
        return life(List.of(SLAB), velocity, x);
    }

    private static SampleHistory life(List<SceneObject> glass, Velocity velocity, double x) {
        Studio studio = Studio.DEFAULT
                .withScene(List.of(WALL))
                .withCameraFrame(glass)
                .withCamera(ThinLensCamera.DEFAULT)
                .withVelocity(velocity)
                .withSettings(Studio.DEFAULT.settings().withSize(100, 100));
        return SampleHistory.of(RenderPlan.of(studio), x, 50, 0, 0);
    }

    /** The event on the way straight through, not on that of a reflection. */
    private static Event leavesTheGlass(SampleHistory life) {
        return life.hits().stream()
                .map(SampleHistory.Encounter::event)
                .filter(event -> Math.abs(event.z() - 4) < 1e-9)
                .max((one, other) -> Double.compare(one.time(), other.time()))
                .orElseThrow();
    }

    @Test
    void lightThroughAMovingSlabComesFromAnEarlierPlace() {
        SampleHistory life = life(Velocity.of(0, 0, 0.8), 50);
        // 2 to the glass, 1.5 times 2 in it
        assertThat(leavesTheGlass(life).time()).isCloseTo(-5, within(1e-12));
        // gamma = 5/3: z = gamma (4 - 0.8 times 5) = 0 at the time gamma (-5 + 0.8 times 4) = -3, and 30 to go
        assertThat(life.hits())
                .filteredOn(hit -> hit.object().description().equals("wall"))
                .anySatisfy(hit -> assertThat(hit.event().time()).isCloseTo(-33, within(1e-12)));
    }

    private static Plane face(double z, double normal) {
        return new Plane("face", new Vector3d(0, 0, z), new Vector3d(0, 0, normal), new Refractive(1.5));
    }

    /** Two planes with their fronts outwards are the faces of a plate, in whatever order they are listed. */
    @Test
    void aPlateOfTwoPlanesIsASlabWithoutAnEdge() {
        Plane front = face(2, -1);
        Plane back = face(4, 1);
        for (List<SceneObject> plate : List.of(List.<SceneObject>of(front, back), List.<SceneObject>of(back, front))) {
            assertThat(leavesTheGlass(life(plate, Velocity.of(0, 0, 0.8), 50)).time())
                    .isCloseTo(-5, within(1e-12));
        }
    }

    /** Light that starts in n plates of glass needs 1.5^n times as long to z = 4 as in vacuum. */
    @Test
    void aLensMayStandBetweenOrInPlates() {
        List<SceneObject> inPlate = List.of(face(-1, -1), face(4, 1));
        List<SceneObject> beforePlate = List.of(face(-5, -1), face(-4, 1), face(-1, -1), face(4, 1));
        List<SceneObject> inTwo = List.of(face(4, 1), face(-4, -1), face(5, 1), face(-5, -1));
        List<SceneObject> between = List.of(face(-5, -1), face(-4, 1), face(4, -1), face(5, 1));
        List<SceneObject> underWater = List.of(face(4, 1), face(9, -1));
        Velocity rest = Velocity.REST;
        assertThat(leavesTheGlass(life(inPlate, rest, 50)).time()).isCloseTo(-4 * 1.5, within(1e-12));
        assertThat(leavesTheGlass(life(beforePlate, rest, 50)).time()).isCloseTo(-4 * 1.5, within(1e-12));
        assertThat(leavesTheGlass(life(inTwo, rest, 50)).time()).isCloseTo(-4 * 1.5 * 1.5, within(1e-12));
        assertThat(leavesTheGlass(life(between, rest, 50)).time()).isCloseTo(-4, within(1e-12));
        assertThat(leavesTheGlass(life(underWater, rest, 50)).time()).isCloseTo(-4 * 1.5, within(1e-12));
    }

    /** Most of the light goes straight on, not back with the 4 % that the front reflects. */
    @Test
    void whatIsToldOfTheRayIsThatOfItsMainBranch() {
        SampleHistory life = life(Velocity.of(0, 0, 0.6), 50);
        // gamma = 5/4: z = gamma (4 - 0.6 times 5), t = gamma (-5 + 0.6 times 4)
        assertThat(life.sceneStart().z()).isCloseTo(1.25, within(1e-12));
        assertThat(life.sceneStart().time()).isCloseTo(-3.25, within(1e-12));
        assertThat(life.sceneDirection().z()).isEqualTo(1);
        assertThat(life.sceneDopplerFactor()).isCloseTo(2, within(1e-12));
        assertThat(life.mainHits())
                .extracting(hit -> hit.object().description())
                .containsExactly("slab", "slab", "wall");
        assertThat(life.hits()).hasSizeGreaterThan(3).anyMatch(hit -> hit.branch() == 1);
    }

    private static SampleHistory fromInside(List<SceneObject> media, Vector3d view, SceneObject seen) {
        Studio studio = Studio.DEFAULT
                .withScene(List.of(seen))
                .withCameraFrame(media)
                .withCamera(Photograph.pinhole(view, 20, 0))
                .withVelocity(Velocity.of(0, 0, 0.8))
                .withSettings(Studio.DEFAULT.settings().withSize(99, 99));
        return SampleHistory.of(RenderPlan.of(studio), 49.5, 49.5, 0, 0);
    }

    /** Around the camera, glass with and without a bubble about the lens, which changes next to nothing. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-3})
    void aCameraInGlassSeesWhatIsOutsideLater(double bubble) {
        SceneObject ball = new Sphere("ball", new Vector3d(), 3, new Refractive(1.5));
        SceneObject side = new Plane("side", new Vector3d(50, 0, 0), new Vector3d(-1, 0, 0), ColouredSurface.DEFAULT);
        List<SceneObject> media = bubble == 0
                ? List.of(ball)
                : List.of(ball, new Sphere("air", new Vector3d(), bubble, new Refractive(1 / 1.5)));
        SampleHistory life = fromInside(media, new Vector3d(1, 0, 0), side);
        // x = 3 at t = -1.5 times 3, and from there at the angle of aberration: gamma = 5/3, tan = gamma 0.8
        assertThat(life.sceneStart().z()).isCloseTo(-6, within(2 * bubble + 1e-12));
        Event seen = life.mainHits().get(life.mainHits().size() - 1).event();
        assertThat(seen.z()).isCloseTo(-6 - 47 * 4 / 3.0, within(2 * bubble + 1e-10));
    }

    @Test
    void aCameraUnderWaterCountsItsWayToTheSurface() {
        SceneObject surface = new Plane("surface", new Vector3d(0, 2, 0), new Vector3d(0, 1, 0), new Refractive(1.33));
        SceneObject sky = new Plane("sky", new Vector3d(0, 9, 0), new Vector3d(0, -1, 0), ColouredSurface.DEFAULT);
        SceneObject bottom =
                new Plane("bottom", new Vector3d(0, -9, 0), new Vector3d(0, 1, 0), ColouredSurface.DEFAULT);
        // from below and from above: z = -gamma beta t
        assertThat(fromInside(List.of(surface), new Vector3d(1e-9, 1, 0), sky)
                        .sceneStart()
                        .z())
                .isCloseTo(-4 / 3.0 * 2 * 1.33, within(1e-7));
        SceneObject below = new Plane("surface", new Vector3d(0, -2, 0), new Vector3d(0, 1, 0), new Refractive(1.33));
        assertThat(fromInside(List.of(below), new Vector3d(1e-9, -1, 0), bottom)
                        .sceneStart()
                        .z())
                .isCloseTo(-4 / 3.0 * 2, within(1e-7));
    }

    /**
     * What the camera is not in does not slow its light: sheets, planes with the camera outside, and balls beside it.
     */
    @Test
    void onlyWhatIsAroundTheLensIsItsMedium() {
        SceneObject ball = new Sphere("ball", new Vector3d(), 3, new Refractive(1.5));
        SceneObject beside = new Sphere("ball", new Vector3d(0, 9, 0), 3, new Refractive(1.5));
        SceneObject sheet = new Disc("sheet", new Vector3d(0, 9, 9), new Vector3d(0, 1, 1), 9, new Refractive(1.4));
        SceneObject wall = new Plane("wall", new Vector3d(-4, 0, 3), new Vector3d(-4, 0, 3), new Refractive(1.3));
        SceneObject floor = new Plane("floor", new Vector3d(0, -4, 0), new Vector3d(0, 1, 0), new Refractive(1.3));
        SceneObject side = new Plane("side", new Vector3d(50, 0, 0), new Vector3d(-1, 0, 0), ColouredSurface.DEFAULT);
        Vector3d view = new Vector3d(1, 0, 0);
        assertThat(fromInside(List.of(sheet, beside, floor, ball), view, side)
                        .sceneStart()
                        .z())
                .isCloseTo(-6, within(1e-12));
        // inside the wall, too, of which the ray meets nothing: -4.5 times 1.3
        assertThat(fromInside(List.of(wall, ball), view, side).sceneStart().z()).isCloseTo(-6 * 1.3, within(1e-12));
        assertThat(fromInside(List.of(sheet, beside, floor), view, side)
                        .sceneStart()
                        .z())
                .isZero();
    }

    @Test
    void aSlantingRayNeedsTheTimeOfItsPathByTheLawOfSnell() {
        SampleHistory life = life(Velocity.REST, 90);
        Vector3d direction = new Vector3d(life.cameraDirection());
        double sine = direction.x / 1.5;
        double pathInGlass = 2 / Math.sqrt(1 - sine * sine);
        Event leaves = leavesTheGlass(life);
        assertThat(direction.x).isGreaterThan(0.1);
        assertThat(leaves.time()).isCloseTo(-2 / direction.z - 1.5 * pathInGlass, within(1e-12));
        assertThat(leaves.x()).isCloseTo(2 * direction.x / direction.z + sine * pathInGlass, within(1e-12));
    }
}
