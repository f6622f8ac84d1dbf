package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.light.AmbientLight;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.light.RestingLight;
import tompkins.primitive.Bounds;
import tompkins.ray.Colour;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;

/** What a world prepares, when it is used for another picture, and where its objects are at a time. */
class WorldTest {

    private static final Event AT_THE_ORIGIN = Event.ORIGIN;
    private static final Event FAR_AWAY = new Event(1e7, 0, 0, 0);
    private static final ColouredSurface COLOUR = ColouredSurface.DEFAULT;
    private static final SceneObject BALL = new Sphere("ball", new Vector3d(), 1, COLOUR);

    private static Studio studio(SceneObject... scene) {
        return Studio.DEFAULT.withScene(List.of(scene));
    }

    private static SceneObject moving(double speed, double place, SceneObject... objects) {
        return new Moving("moving", Velocity.of(speed, 0, 0), new Vector3d(place, 0, 0), 0, List.of(objects));
    }

    private static FrameTree frames(Studio studio, Event lens) {
        return FrameTree.near(lens, studio.transformation(), studio.velocity());
    }

    private static World world(Studio studio) {
        return new World(studio, frames(studio, AT_THE_ORIGIN), point -> Event.ORIGIN);
    }

    private static boolean serves(Studio before, Studio after, Event lens) {
        return world(before).isOf(after, frames(after, lens));
    }

    /** A law of motion matters only to what moves, be it an object or a lamp; coordinates begin near the camera. */
    @Test
    void worldServesWhatChangesNothingInIt() {
        Studio rest = studio(BALL).withVelocity(Velocity.of(0, 0.3, 0));
        Studio motion = rest.withScene(List.of(moving(0.6, 0, BALL)));
        Studio lamp = Lighting.of(rest, List.of(MovingLights.DEFAULT));
        Studio galilean = rest.withTransformation(TransformationLaw.GALILEAN);

        assertThat(serves(motion, motion.withVelocity(Velocity.REST), new Event(5, 0, 0, 3)))
                .isTrue();
        assertThat(serves(rest, galilean, AT_THE_ORIGIN)).isTrue();
        assertThat(serves(rest, rest, FAR_AWAY)).isFalse();
        assertThat(List.of(motion, Lighting.of(rest, List.of())))
                .noneMatch(other -> serves(rest, other, AT_THE_ORIGIN));
        assertThat(List.of(motion, lamp, rest.withScene(List.of(moving(0.6, 0)))))
                .noneMatch(each -> serves(each, each.withTransformation(TransformationLaw.GALILEAN), AT_THE_ORIGIN));
    }

    @Test
    void worldWithImagePointsFollowsTheCamera() {
        Studio studio = studio(ImagePointGrid.DEFAULT);

        assertThat(world(studio).followsCamera()).isTrue();
        assertThat(serves(studio, studio, AT_THE_ORIGIN)).isFalse();
        assertThat(world(studio(BALL)).followsCamera()).isFalse();
    }

    /** A ball of radius 1 that starts at 2: its box is contracted by gamma, which is 17/8 for 0.6 in 0.6. */
    @ParameterizedTest
    @CsvSource({"LORENTZ, 5, 0.8", "GALILEAN, 5, 1"})
    void boxesAreWhereTheObjectsAre(TransformationLaw law, double middle, double half) {
        SceneObject plane = new Plane("no bounds", new Vector3d(0, -3, 0), new Vector3d(0, 1, 0), COLOUR);
        Studio studio = studio(plane, BALL, moving(0.6, 2, BALL)).withTransformation(law);

        List<Bounds> boxes = world(studio).bounds(5, 9);

        assertThat(boxes).hasSize(2);
        assertBox(boxes.get(0), 0, 1);
        assertBox(boxes.get(1), middle, half);
        assertThat(world(studio).bounds(5, 1)).containsExactly(boxes.get(0));
    }

    private static void assertBox(Bounds box, double middle, double half) {
        assertThat(box.minX()).isCloseTo(middle - half, within(1e-9));
        assertThat(box.maxX()).isCloseTo(middle + half, within(1e-9));
        assertThat(box.minY()).isCloseTo(-1, within(1e-9));
        assertThat(box.maxZ()).isCloseTo(1, within(1e-9));
    }

    @Test
    void nestedMotionsAddAsVelocitiesDo() {
        World world = world(studio(moving(0.6, 0, moving(0.6, 0, BALL))));

        assertThat(world.frames()).extracting(frame -> frame.objects().size()).containsExactly(0, 0, 1);
        assertBox(world.bounds(17, 9).get(0), 15, 8.0 / 17);
    }

    /** Frames are the scene (0), one in it (1) with two inside (2 and 3), and another one in the scene (4). */
    @ParameterizedTest
    @CsvSource({"2, 1, 3, true", "2, 0, 4, true", "2, 2, 4, true", "2, 0, 3, false", "1, 4, 0, false"})
    void waysLeadThroughTheFramesBetween(int from, int third, int to, boolean expected) {
        SceneObject inner = moving(0.1, 0, BALL);
        Studio studio = studio(moving(0.6, 0, BALL, inner, moving(0.2, 0, BALL)), moving(0.3, 0, BALL));
        FrameRoutes routes = world(studio).routes(frames(studio, AT_THE_ORIGIN));

        assertThat(routes.passesThrough(from, third, to)).isEqualTo(expected);
    }

    /** Coordinates begin near a moving camera that is far away; boxes are told in those of the scene. */
    @Test
    void boxesAreInCoordinatesOfTheScene() {
        Studio studio =
                studio(new Sphere("far", new Vector3d(1e7, 0, 0), 1, COLOUR)).withVelocity(Velocity.of(0, 0.3, 0));
        World world = new World(studio, frames(studio, FAR_AWAY), point -> Event.ORIGIN);

        assertThat(world.objects(0).primitives().get(0).bounds().centre().length())
                .isLessThan(1e-6);
        assertBox(world.bounds(0, 9).get(0), 1e7, 1);
    }

    private static LightSource lamp(double x) {
        return new PointLight(new Vector3d(x, 0, 0), Colour.WHITE, Colour.WHITE, 1);
    }

    /** To prepare what a lamp sees takes time and memory: for the seventeenth with a place the tree answers. */
    @Test
    void onlySixteenLampsArePrepared() {
        List<LightSource> lights = new ArrayList<>(Collections.nCopies(17, lamp(9)));
        lights.add(0, AmbientLight.DEFAULT);

        List<Lamp> lamps = world(Lighting.of(studio(BALL), lights)).lamps();

        assertThat(lamps)
                .extracting(lamp -> lamp.tracks().size())
                .startsWith(0, 1)
                .endsWith(1, 0);
        assertThat(lamps.get(16).shadows()).isNotNull();
        assertThat(lamps.get(17).shadows()).isNull();
    }

    /** Lamps in motion light the camera's rest frame as if at rest, where they are at time 0. */
    @Test
    void lampsStandAtTheirPlaceAtTimeZero() {
        LightSource inner = new MovingLights(Velocity.of(0, 0, 0.3), new Vector3d(0, 5, 0), List.of(lamp(1)));
        LightSource outer = new MovingLights(Velocity.of(0.6, 0, 0), new Vector3d(2, 0, 0), List.of(inner, lamp(7)));

        assertThat(Stream.of(lamp(4), outer).flatMap(LightSource::atRest))
                .extracting(RestingLight::position)
                .containsExactly(new Vector3d(4, 0, 0), new Vector3d(3, 5, 0), new Vector3d(9, 0, 0));
    }
}
