package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.Refractive;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** Light in glass and water through which cameras and objects move, against closed forms. */
class MediaFactsTest {

    private static final double EXACT = 1e-12;
    private static final Vector3dc AHEAD = new Vector3d(0, 0, 1);
    private static final Vector3dc ACROSS = new Vector3d(1, 0, 0);

    /** A ball of a medium at rest around the origin, in a white shell, seen along a direction, one pixel. */
    private static Studio studio(double index, Velocity camera, Vector3dc view, SceneObject... others) {
        List<SceneObject> scene = new ArrayList<>(List.of(others));
        scene.add(new Sphere("medium", new Vector3d(), 30, new Refractive(index)));
        scene.add(new Sphere("shell", new Vector3d(), 60, Photograph.WHITE));
        return Descriptions.with(Studios.dark(), "metering", Metering.NONE)
                .withScene(scene)
                .withVelocity(camera)
                .withCamera(Photograph.pinhole(view, 10, 0))
                .withColours(ColourLaw.SEARCHLIGHT)
                .withSettings(Studio.DEFAULT.settings().withSize(1, 1));
    }

    private static SampleHistory life(Studio studio) {
        return SampleHistory.of(RenderPlan.of(studio), 0.5, 0.5, 0, 0);
    }

    private static Moving moving(Velocity velocity, SceneObject... objects) {
        return new Moving("", velocity, new Vector3d(), 0, List.of(objects));
    }

    /** n = 1.5, b = .5: gamma (1 + n b) ahead, gamma (1 - n^2 b^2) across, and the radiances 1/L^4. */
    @Test
    void cameraInGlassSeesTheFrequencyOfTheWave() {
        Velocity half = Velocity.of(0, 0, 0.5);

        SampleHistory ahead = life(studio(1.5, half, AHEAD));
        assertThat(ahead.sceneDopplerFactor()).isCloseTo(2.020725942163690, within(EXACT));
        assertThat(ahead.colour().red()).isCloseTo(Math.pow(2.020725942163690, 4), within(1e-10));
        SampleHistory across = life(studio(1.5, half, ACROSS));
        assertThat(across.sceneDopplerFactor()).isCloseTo((1 - 0.5625) / Math.sqrt(0.75), within(EXACT));
        assertThat(across.colour().red()).isCloseTo(0.4375 * 0.4375, within(EXACT));
        assertThat(across.sceneDirection().dot(0, 0, 1)).isCloseTo(-0.75, within(EXACT));
    }

    /** At rest relative to the medium nothing is shifted, whatever both do. */
    @ParameterizedTest
    @ValueSource(doubles = {1.2, 10, 1e4, 1e6})
    void companionsOfTheGlassSeeItAtRest(double gamma) {
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, gamma, new Vector3d(0.5, 0.2, -0.3));
        SceneObject glass = new Sphere("glass", new Vector3d(), 30, new Refractive(1.5));
        SceneObject shell = new Sphere("shell", new Vector3d(), 60, Photograph.WHITE);
        Studio studio = studio(1.5, velocity, ACROSS).withScene(List.of(moving(velocity, glass, shell)));

        SampleHistory life = life(studio);
        SampleHistory.Rest first = life.mainHits().get(0).rest();
        assertThat(first.dopplerFactor()).isEqualTo(1);
        assertThat(first.event().time()).isCloseTo(-45, within(1e-9));
        assertThat(life.colour().red()).isCloseTo(1, within(1e-12));
    }

    /** Water of 4/3, an object that comes with .3 and one that goes, and one that outruns its light in glass. */
    @ParameterizedTest
    @CsvSource({
        "1.3333333333333333, 0.3, 1.5898986690282428",
        "1.3333333333333333, -0.3, 0.6813851438692469",
        "1.5, 0.9, -1.2453996981"
    })
    void objectsMoveThroughTheMedium(double index, double speed, double ratio) {
        SceneObject wall = new Plane("wall", new Vector3d(), new Vector3d(0, 0, -1), Photograph.WHITE);
        Moving coming = new Moving(
                "", Velocity.of(0, 0, -speed), new Vector3d(0, 0, 10 * (1 - index * speed)), 0, List.of(wall));
        CrestCount crests = new CrestCount(studio(index, Velocity.REST, AHEAD, coming));

        CrestCount.Counted seen = crests.at(0.5, 0.5).get(0);
        assertThat(seen.hit().event().position().z).isCloseTo(10, within(1e-9));
        assertThat(seen.told()).isCloseTo(ratio, within(1e-9));
        assertThat(seen.counted()).isCloseTo(ratio, within(1e-6));
    }

    /** Beyond .9 in glass: ahead the camera sees gamma (1 + n b), outside a cone of 25.6702 degrees nothing. */
    @Test
    void cameraThatOutrunsLightSeesACone() {
        Velocity fast = Velocity.of(0, 0, 0.9);
        double edge = Math.atan(1 / (Velocity.of(0, 0, 0.9).gamma() * Math.sqrt(1.5 * 1.5 * 0.81 - 1)));

        assertThat(Math.toDegrees(edge)).isCloseTo(25.6702, within(1e-4));
        assertThat(life(studio(1.5, fast, AHEAD)).sceneDopplerFactor()).isCloseTo(5.39127, within(1e-5));
        for (double inside : new double[] {edge - 1e-6, edge + 1e-6}) {
            Vector3d look = new Vector3d(Math.sin(inside), 0, Math.cos(inside));
            boolean isSeen = life(studio(1.5, fast, look)).sceneStart() != null;
            assertThat(isSeen).isEqualTo(inside < edge);
        }
    }

    /** A plate with parallel sides that moves changes neither direction nor frequency. */
    @Test
    void movingPlateChangesNothing() {
        Moving plate = moving(
                Velocity.of(0.1, -0.2, 0.4),
                new Box("plate", new Vector3d(-1000, -1000, 5), new Vector3d(1000, 1000, 7), new Refractive(1.5)));
        Studio studio = studio(1, Velocity.REST, new Vector3d(0.3, 0.1, 1), plate);

        SampleHistory life = life(studio.withScene(studio.scene().stream()
                .filter(object -> !object.description().equals("medium"))
                .toList()));
        assertThat(life.mainHits()).hasSize(3);
        SampleHistory.Encounter shell = life.end();
        assertThat(shell.rest().dopplerFactor()).isCloseTo(1, within(EXACT));
        Vector3d way =
                shell.event().position().sub(life.mainHits().get(1).event().position());
        assertThat(way.normalize().distance(new Vector3d(life.cameraDirection())))
                .isLessThan(EXACT);
    }

    /** A camera that has flown in the glass for a long time sees what it saw, and in the same directions. */
    @ParameterizedTest
    @ValueSource(doubles = {1e6, 1e12})
    void cameraFarFromTheOriginSeesTheSame(double time) {
        Velocity velocity = Velocity.of(0.1, -0.2, 0.3);
        Vector3d view = new Vector3d(0.3, 0.5, 1);
        SampleHistory near = life(studio(1.5, velocity, view));
        Vector3d there = new Vector3d(velocity.proper()).mul(time);
        Studio far = studio(1.5, velocity, view)
                .withScene(List.of(
                        new Sphere("medium", there, 30, new Refractive(1.5)),
                        new Sphere("shell", there, 60, Photograph.WHITE)))
                .withCamera(Photograph.pinhole(view, 10, time));

        SampleHistory seen = life(far);
        assertThat(seen.sceneDirection().distance(near.sceneDirection())).isLessThan(1e-12);
        assertThat(seen.sceneDopplerFactor()).isCloseTo(near.sceneDopplerFactor(), within(1e-12));
        // the centre of the glass itself has no more digits than this
        assertThat(seen.mainHits().get(0).distance()).isCloseTo(30, within(4e-16 * time * 2 + 1e-9));
    }
}
