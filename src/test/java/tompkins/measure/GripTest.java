package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.PanoramicCamera;
import tompkins.light.AmbientLight;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.TriangleMesh;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.studio.View;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Mirror;
import tompkins.surface.Tiling;
import tompkins.trace.RenderPlan;

/** An object that is held elsewhere, against a closed formula and against the picture that is traced anew. */
class GripTest {

    private static final Velocity FAST = Velocity.of(0, 0, 0.8);
    private static final Velocity ACROSS = Velocity.of(0.5, 0.2, -0.3);
    private static final StudioPath NOTHING = StudioPath.ROOT;

    /** A ball whose points can be told apart, 10 before the lens. */
    private static final Sphere BALL = ball(0.2, 0.1, 10, 1);

    private static Sphere ball(double x, double y, double z, double radius) {
        return new Sphere("ball", new Vector3d(x, y, z), radius, Tiling.DEFAULT);
    }

    private static Studio studio(Velocity velocity, SceneObject... scene) {
        return Studio.DEFAULT.withScene(List.of(scene)).withVelocity(velocity);
    }

    private static StudioPath path(String text) {
        return StudioPath.parse(text).orElseThrow();
    }

    private static Grip grip(Studio studio, double x, double y, StudioPath chosen) {
        RenderPlan plan = RenderPlan.of(studio);
        return Grip.of(plan, Sighting.of(plan, x, y), chosen).orElseThrow();
    }

    private static boolean isFree(Studio studio, double x, double y, StudioPath chosen) {
        RenderPlan plan = RenderPlan.of(studio);
        return Grip.of(plan, Sighting.of(plan, x, y), chosen).isEmpty();
    }

    /** In a pinhole at rest, 100 pixels at the depth of 9 are 9 tan(a/2) 100/320 wide, in a picture 640 wide. */
    @Test
    void aBallAtRestMovesByThePinholeFormula() {
        Sphere ball = new Sphere("ball", new Vector3d(0, 0, 10), 1, ColouredSurface.DEFAULT);
        Studio studio = studio(Velocity.REST, ball);
        Sphere moved = (Sphere) grip(studio, 320, 240, NOTHING).at(420, 215).orElseThrow();
        double pixel = 9 * Math.tan(Math.toRadians(studio.camera().horizontalAngleDegrees() / 2)) / 320;
        assertThat(moved.centre().x()).isCloseTo(100 * pixel, within(0.1 * pixel));
        assertThat(moved.centre().y()).isCloseTo(25 * pixel, within(0.1 * pixel));
        assertThat(moved.centre().z()).isEqualTo(10);
        assertThat(pixel).as("a tenth of it needs four decimals").isBetween(0.001, 0.01);
        assertThat(moved.centre().x() * 1e4).isCloseTo(Math.rint(moved.centre().x() * 1e4), within(1e-9));
    }

    /** What the plane across the sight is in the scene: the depth along the first ray stays. */
    @Test
    void theDepthInTheSceneStaysWhileTheCameraMoves() {
        Studio studio = studio(FAST, BALL);
        RenderPlan plan = RenderPlan.of(studio);
        Vector3dc sight = Sighting.of(plan, 330, 235).sceneDirection();
        Sphere moved = (Sphere) grip(studio, 330, 235, NOTHING).at(500, 100).orElseThrow();
        Vector3d way = moved.centre().sub(BALL.centre(), new Vector3d());
        assertThat(way.length()).isGreaterThan(1);
        assertThat(way.dot(sight)).isCloseTo(0, within(0.003));
    }

    static Stream<Arguments> scenes() {
        Rotating wheel = new Rotating(
                "wheel", new Vector3d(0, 0, 10), new Vector3d(0.2, 0.3, 1), 0.4, 20, List.of(ball(0, 0, 10, 1)));
        Moving car = new Moving("car", ACROSS, new Vector3d(5, 2, -3), 3, List.of(wheel));
        Moving ship = new Moving("ship", ACROSS, new Vector3d(5, 2, -3), 0, List.of(BALL));
        Moving inner = new Moving("boat", Velocity.of(-0.6, 0, 0.1), new Vector3d(), 0, List.of(BALL));
        Moving outer = new Moving("ship", ACROSS, new Vector3d(1, 0, 0), 0, List.of(inner));
        Moving now = new Moving("ship", ACROSS, new Vector3d(-3.5, -1.3, 2), 0, List.of(BALL));
        Moving turning = new Moving("car", ACROSS, new Vector3d(-3.5, -1.3, 2), 0, List.of(wheel));
        Moving still = new Moving("car", ACROSS, new Vector3d(), 0, List.of(wheel));
        Moving early = new Moving("ship", ACROSS, new Vector3d(8.5, 3.3, -3), 0, List.of(BALL));
        Studio galilean = studio(Velocity.of(0, 0, 0.3), early).withTransformation(TransformationLaw.GALILEAN);
        Placed placed =
                new Placed("placed", ball(0, 0, 0, 0.5), 2, new Vector3d(1, 2, 3), 70, new Vector3d(0.2, 0, 10));
        Moving loaded = new Moving("ship", ACROSS, new Vector3d(5, 2, -3), 0, List.of(placed));
        Placed fleet = new Placed("fleet", loaded, 0.5, new Vector3d(0, 0, 1), 30, new Vector3d(1, 1, 5));
        Group group = new Group("group", List.of(BALL, Sphere.DEFAULT.shifted(new Vector3d(4, 0, 0))));
        Studio onBoard = studio(FAST).withCameraFrame(List.of(BALL));
        Plane window = new Plane(
                "window",
                new Vector3d(0, 0, 0.01),
                new Vector3d(0, 0, 1),
                Descriptions.with(LorentzWindow.DEFAULT, "velocity", FAST));
        Studio rolling = studio(FAST, ship)
                .withCamera(Studio.DEFAULT
                        .camera()
                        .withShutter(new DetectorPlaneShutter(0.5, 2))
                        .withRollingShutter(new RollingShutter(SweepDirection.RIGHT, 0.8)));
        Studio panorama = studio(FAST, ship)
                .withCamera(Descriptions.with(PanoramicCamera.DEFAULT, "horizontalAngleDegrees", 120.0));
        return Stream.of(
                arguments("at 0.8 c", studio(FAST, BALL), "scene[0]"),
                arguments("in a group", studio(FAST, group), "scene[0]"),
                arguments("placed", studio(FAST, placed), "scene[0]"),
                arguments("in its place", studio(FAST, placed), "scene[0].object"),
                arguments("what moves", studio(FAST, ship), "scene[0]"),
                arguments("in what moves", studio(FAST, ship), "scene[0].objects[0]"),
                arguments("what moves in what moves", studio(FAST, outer), "scene[0].objects[0]"),
                arguments("all that moves", studio(FAST, outer), "scene[0]"),
                arguments("placed in what moves", studio(FAST, loaded), "scene[0].objects[0].object"),
                arguments("placed motion", studio(FAST, fleet), "scene[0].object"),
                arguments("placed in a placed motion", studio(FAST, fleet), "scene[0].object.objects[0].object"),
                arguments("what turns", studio(FAST, wheel), "scene[0]"),
                arguments("in what turns", studio(FAST, wheel), "scene[0].objects[0]"),
                arguments("what turns and moves", studio(FAST, car), "scene[0]"),
                arguments("turning in what moves", studio(FAST, car), "scene[0].objects[0]"),
                arguments("in what turns and moves", studio(FAST, car), "scene[0].objects[0].objects[0]"),
                arguments("on board", onBoard, "cameraFrame[0]"),
                arguments("through a window", studio(FAST, ship).withCameraFrame(List.of(window)), "scene[0]"),
                arguments("rolling", rolling, "scene[0]"),
                arguments("panorama", panorama, "scene[0]"),
                arguments("measured", studio(FAST, now).withView(View.MEASURED), "scene[0]"),
                arguments("measured turn", studio(FAST, turning).withView(View.MEASURED), "scene[0]"),
                arguments("Galilean", galilean, "scene[0]"),
                arguments("no motion", studio(FAST, still).withTransformation(TransformationLaw.NONE), "scene[0]"));
    }

    /** The same paint is seen at the new place, but for a part of a pixel. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("scenes")
    void theHeldPointIsSeenUnderThePointer(String name, Studio studio, String chosen) {
        RenderPlan before = RenderPlan.of(studio);
        double[] pixel = whereTheBallIs(before);
        double x = pixel[0];
        double y = pixel[1];
        Grip grip = grip(studio, x, y, path(chosen));
        assertThat(grip.path()).hasToString(chosen);
        for (double[] way : new double[][] {{40, 0}, {-60, 35}, {25, -70}}) {
            Object moved = grip.at(x + way[0], y + way[1]).orElseThrow();
            RenderPlan after = RenderPlan.of(grip.path().with(studio, moved));
            assertThat(paint(after, x + way[0], y + way[1]))
                    .as("%s to %s, %s", moved, way[0], way[1])
                    .matches(paint -> isSame(before, paint, x, y), "the paint of the held point");
        }
    }

    static Stream<Arguments> lamps() {
        Sphere small = ball(0.2, 0.1, 10, 0.2);
        PointLight lamp = new PointLight(small.centre(), Colour.WHITE, Colour.WHITE, 40);
        Vector3d place = new Vector3d(5, 2, -3);
        Velocity inner = Velocity.of(-0.6, 0, 0.1);
        Studio boat =
                studio(FAST, moving(ACROSS, new Vector3d(1, 0, 0), moving(inner, new Vector3d(0.1, 0, 0), small)));
        MovingLights boatLamp = new MovingLights(
                ACROSS,
                new Vector3d(1, 0, 0),
                List.of(new MovingLights(inner, new Vector3d(0.1, 0, 0), List.of(lamp))));
        Studio ship = studio(FAST, moving(ACROSS, place, small));
        MovingLights shipLamp = new MovingLights(ACROSS, place, List.of(lamp));
        Studio parked = studio(FAST, moving(Velocity.REST, new Vector3d(0.2, 0, 0), small));
        MovingLights parkedLamp = new MovingLights(Velocity.REST, new Vector3d(0.2, 0, 0), List.of(lamp));
        return Stream.of(
                arguments("at rest", studio(FAST, small), lamp, "lights[1]"),
                arguments("moving", ship, shipLamp, "lights[1].objects[0]"),
                arguments("in what moves in what moves", boat, boatLamp, "lights[1].objects[0].objects[0]"),
                arguments("in what rests", parked, parkedLamp, "lights[1].objects[0]"));
    }

    private static Moving moving(Velocity velocity, Vector3d place, SceneObject object) {
        return new Moving("ship", velocity, place, 0, List.of(object));
    }

    /** A lamp is seen where a ball in its place is, and goes where the pointer goes. */
    @ParameterizedTest(name = "{0}")
    @MethodSource
    void lamps(String name, Studio withBall, LightSource light, String path) {
        double[] middle = whereTheBallIs(RenderPlan.of(withBall));
        Studio studio =
                Descriptions.with(withBall.withScene(List.of()), "lights", List.of(AmbientLight.DEFAULT, light));
        RenderPlan plan = RenderPlan.of(studio);
        SeenLamp lamp = SeenLamp.near(plan, middle[0], middle[1]).orElseThrow();
        assertThat(lamp.path()).hasToString(path);
        assertThat(lamp.place().distance(middle[0], middle[1])).isLessThan(4);
        assertThat(SeenLamp.near(plan, middle[0] + 20, middle[1])).isEmpty();
        double x = lamp.place().x() - 40;
        double y = lamp.place().y() + 30;
        Grip grip = Grip.of(plan, lamp).orElseThrow();
        Studio moved = grip.path().with(studio, grip.at(x, y).orElseThrow());
        List<SeenLamp> seen = SeenLamp.of(RenderPlan.of(moved));
        assertThat(seen).hasSize(1);
        assertThat(seen.get(0).place().distance(x, y)).isLessThan(0.2);
    }

    /** The middle of the pixels in which the ball is seen. */
    private static double[] whereTheBallIs(RenderPlan plan) {
        List<double[]> inside = new ArrayList<>();
        for (int y = 100; y < plan.height() - 100; y += 4) {
            for (int x = 100; x < plan.width() - 100; x += 4) {
                if (paint(plan, x, y) != null) {
                    inside.add(new double[] {x, y});
                }
            }
        }
        return IntStream.range(0, 2)
                .mapToDouble(i ->
                        inside.stream().mapToDouble(pixel -> pixel[i]).average().orElseThrow())
                .toArray();
    }

    /** Where a point of the picture lies on the ball; null beside it. */
    private static double[] paint(RenderPlan plan, double x, double y) {
        Sighting seen = Sighting.of(plan, x, y);
        return seen.hit() == null || !seen.hit().object().description().equals("ball")
                ? null
                : new double[] {seen.hit().rest().u(), seen.hit().rest().v()};
    }

    private static boolean isSame(RenderPlan plan, double[] paint, double x, double y) {
        double[] held = paint(plan, x, y);
        double[] right = paint(plan, x + 1, y);
        double[] down = paint(plan, x, y + 1);
        // the place of the paint in pixels, by Cramer's rule
        double uRight = right[0] - held[0];
        double vRight = right[1] - held[1];
        double uDown = down[0] - held[0];
        double vDown = down[1] - held[1];
        double u = paint[0] - held[0];
        double v = paint[1] - held[1];
        double determinant = uRight * vDown - uDown * vRight;
        return Math.hypot(u * vDown - uDown * v, uRight * v - u * vRight) < 0.5 * Math.abs(determinant);
    }

    /** A mesh that is placed has its place there, and not in a second placement around it. */
    @ParameterizedTest
    @ValueSource(strings = {"scene[0]", "scene[0].object", "scene[1]"})
    void aPlacedMeshChangesItsPlace(String chosen) {
        Placed placed =
                new Placed("placed", TriangleMesh.DEFAULT, 2, new Vector3d(0, 0, 1), 30, new Vector3d(0, 0, 10));
        Grip grip = grip(studio(Velocity.REST, placed, Sphere.DEFAULT), 321, 241, path(chosen));
        assertThat(grip.path()).hasToString("scene[0]");
        Placed moved = (Placed) grip.at(401, 201).orElseThrow();
        assertThat(moved.object()).isEqualTo(TriangleMesh.DEFAULT);
        // the tip of the octahedron is 8 before the pinhole
        double pixel = 8 * Math.tan(Math.toRadians(Studio.DEFAULT.camera().horizontalAngleDegrees() / 2)) / 320;
        assertThat(moved.translation().x()).isCloseTo(80 * pixel, within(pixel));
        assertThat(moved.translation().y()).isCloseTo(40 * pixel, within(pixel));
        assertThat(moved.translation().z()).isCloseTo(10, within(pixel));
    }

    @Test
    void aPointThatStaysMovesNothing() {
        Grip grip = grip(studio(FAST, BALL), 330, 235, NOTHING);
        assertThat(grip.at(330, 235)).contains(BALL);
    }

    @Test
    void thereIsNoGripWhereNothingCanBeTaken() {
        Studio studio = studio(FAST, BALL);
        assertThat(isFree(studio, 5, 5, NOTHING)).as("the sky").isTrue();
        Plane mirror = new Plane("wall", new Vector3d(0, 0, 5), new Vector3d(0, 0, -1), new Mirror(1));
        Sphere behind = ball(0, 0, -10, 1);
        Studio mirrored = studio(Velocity.REST, mirror, behind);
        assertThat(isFree(mirrored, 320, 240, NOTHING)).as("a mirrored ball").isTrue();
        assertThat(grip(mirrored, 320, 240, path("scene[0]")).path())
                .as("the mirror itself, if it is chosen")
                .isEqualTo(path("scene[0]"));
        Studio grid = studio(Velocity.REST, ImagePointGrid.DEFAULT);
        assertThat(isFree(grid, 320, 240, path("scene[0]"))).as("a grid").isTrue();
    }

    /** A ray that runs beside the plane, or away from it, brings the point nowhere. */
    @Test
    void aRayAwayFromThePlaneMovesNothing() {
        Studio studio = studio(Velocity.REST, BALL)
                .withCamera(Descriptions.with(PanoramicCamera.DEFAULT, "horizontalAngleDegrees", 360.0));
        double x = 320 + 640 * Math.atan2(0.2, 10) / (2 * Math.PI);
        assertThat(grip(studio, x, 240, NOTHING).at(x + 150, 240)).isPresent();
        assertThat(grip(studio, x, 240, NOTHING).at(x + 165, 240)).isEmpty();
        assertThat(grip(studio, x, 240, NOTHING).at(x + 300, 240)).isEmpty();
    }

    @Test
    void aPlainFloorLooksTheSameAlongItself() {
        Plane plain = new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), ColouredSurface.DEFAULT);
        Plane tiled = new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), Tiling.DEFAULT);
        Grip grip = grip(studio(Velocity.REST, plain), 320, 400, NOTHING);
        assertThat(grip.leavesAlike(grip.at(400, 400).orElseThrow())).isTrue();
        assertThat(grip.leavesAlike(grip.at(320, 380).orElseThrow())).isFalse();
        Grip ofTiles = grip(studio(Velocity.REST, tiled), 320, 400, NOTHING);
        assertThat(ofTiles.leavesAlike(ofTiles.at(400, 400).orElseThrow())).isFalse();
    }
}
