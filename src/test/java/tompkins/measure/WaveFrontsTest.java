package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.camera.StereoLayout;
import tompkins.camera.ThinLensCamera;
import tompkins.io.BundledScenes;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;
import tompkins.trace.RenderPlan;

/** Wave fronts lie where closed formulas say, within half a pixel, and nothing of them is missing. */
class WaveFrontsTest {

    private static final ColouredSurface DULL = new ColouredSurface(Colour.WHITE, Colour.BLACK);
    private static final Vector3dc CENTRE = new Vector3d();
    private static final Vector3dc AHEAD = new Vector3d(0, 0, 1);
    private static final Pulse ONCE = new Pulse(0, 0.5, 0);

    private static LightSource lamp(Vector3dc place, Pulse flash) {
        return new PointLight(place, Colour.WHITE, Colour.BLACK, 1, flash);
    }

    private static Plane wall(double distance) {
        return new Plane("wall", new Vector3d(0, 0, distance), new Vector3d(0, 0, -1), DULL);
    }

    /** A pinhole at the origin, with a view of 130 degrees. */
    private static Studio studio(double time, LightSource lamp, SceneObject... objects) {
        return Lighting.of(Studios.dark().withScene(List.of(objects)), List.of(lamp))
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", 130.0)
                        .withShutter(new AperturePlaneShutter(time)))
                .withSettings(Studio.DEFAULT.settings().withSize(600, 600));
    }

    private static Studio aimed(Studio studio, Vector3dc from, Vector3dc view) {
        return studio.withCamera(
                Descriptions.with(Descriptions.with(studio.camera(), "position", from), "viewDirection", view));
    }

    private static List<List<Vector2dc>> fronts(Studio studio) {
        RenderPlan plan = RenderPlan.of(studio);
        return new Overlays(Projection.of(studio), SceneShapes.of(plan.world().frames()), plan)
                .draw(OverlayKind.WAVE_FRONTS)
                .lines();
    }

    private static Stream<Vector2dc> points(List<List<Vector2dc>> lines) {
        return lines.stream().flatMap(List::stream);
    }

    private static double length(List<List<Vector2dc>> lines) {
        return lines.stream()
                .mapToDouble(line -> line.get(0).distance(line.get(1)))
                .sum();
    }

    /** A whole circle of directions around the view, and nothing else. */
    private static void expectCircle(Studio studio, double degrees) {
        List<List<Vector2dc>> lines = fronts(studio);
        Projection projection = Projection.of(studio);
        double radius = 300 / Math.tan(Math.toRadians(65)) * Math.tan(Math.toRadians(degrees));

        assertThat(lines).isNotEmpty();
        assertThat(points(lines)).allSatisfy(point -> {
            double angle = Angles.between(projection.direction(point.x(), point.y()), AHEAD);
            assertThat(Math.toDegrees(angle))
                    .isCloseTo(degrees, within(Math.toDegrees(projection.pixelAngle(point.x(), point.y())) / 2));
        });
        assertThat(length(lines)).isCloseTo(2 * Math.PI * radius, within(0.004 * Math.PI * radius));
    }

    /** Lamp and camera at one place, a wall h away, time T: cos a = 2h/T; and what a camera sees that flies through. */
    @ParameterizedTest
    @CsvSource({"2, 0, 36.8699", "1.5, 0, 53.1301", "1.5, 0.6, 28.0725"})
    void aFlashBesideTheCameraIsACircle(double distance, double speed, double degrees) {
        double gamma = 1 / Math.sqrt(1 - speed * speed);
        Studio studio = studio(gamma * 5, lamp(CENTRE, ONCE), wall(distance)).withVelocity(Velocity.of(0, 0, speed));
        expectCircle(aimed(studio, new Vector3d(0, 0, -gamma * speed * 5), AHEAD), degrees);
    }

    /** The lamp flies with the camera, h = 10 from the wall at its flash: cos a = 2h/(gamma T) - v = 11/15. */
    @Test
    void theCamerasOwnLampIsACircle() {
        LightSource own = new MovingLights(
                Velocity.of(0, 0, 0.6), CENTRE, List.of(new PointLight(CENTRE, Colour.WHITE, Colour.BLACK, 1, ONCE)));
        expectCircle(studio(12, own, wall(10)).withVelocity(Velocity.of(0, 0, 0.6)), 42.8334);
    }

    /** The camera rests, and lamp and wall come with 0.6: the same events as if the camera flew. */
    @Test
    void aWallThatComesShowsTheSameCircle() {
        Velocity towards = Velocity.of(0, 0, -0.6);
        LightSource coming =
                new MovingLights(towards, CENTRE, List.of(new PointLight(CENTRE, Colour.WHITE, Colour.BLACK, 1, ONCE)));
        double gamma = 1.25;
        SceneObject sheet = new Moving(
                "",
                towards,
                new Vector3d(),
                0,
                List.of(new Disc("", new Vector3d(0, 0, 1.5), new Vector3d(0, 0, -1), 99, DULL)));
        expectCircle(aimed(studio(gamma * 5, coming, sheet), new Vector3d(0, 0, -gamma * 0.6 * 5), AHEAD), 28.0725);
    }

    /** Radius 1, 10 away, time 19: cos a = (Z² + rho² - R²)/(2 Z rho) with rho = T/2. */
    @Test
    void theEchoOfABallIsACircle() {
        expectCircle(studio(19, lamp(CENTRE, ONCE), new Sphere("ball", new Vector3d(0, 0, 10), 1, DULL)), 5.09254);
    }

    /** The camera's image in the mirror is 2 ahead, 5 from the wall behind, and the lamp is 3 from it; 9 in all. */
    @Test
    void aMirrorShowsTheFrontThatIsSeenInIt() {
        Disc mirror = new Disc("mirror", AHEAD, new Vector3d(0, 0, -1), 2, new Mirror(1));
        Plane behind = new Plane("wall", new Vector3d(0, 0, -3), AHEAD, DULL);
        double fromLamp = 65 / 18.0;
        double radius = Math.sqrt(fromLamp * fromLamp - 9);
        assertThat(radius).isCloseTo(2.01001, within(1e-4));
        expectCircle(studio(9, lamp(CENTRE, ONCE), behind, mirror), Math.toDegrees(Math.atan(radius / 5)));
    }

    /** Lamp and camera 6 apart and 2 above a floor, time 9: an ellipse with the half axes 3.61248 and 2.69258. */
    @Test
    void aFlashBesidesIsAnEllipseOnTheFloor() {
        Plane floor = new Plane("floor", CENTRE, new Vector3d(0, 1, 0), DULL);
        Vector3d from = new Vector3d(0, 2, 0);
        Studio studio = aimed(studio(9, lamp(new Vector3d(6, 2, 0), ONCE), floor), from, new Vector3d(3, -2, 0));
        Projection projection = Projection.of(studio);
        List<Double> along = new ArrayList<>();
        List<Double> across = new ArrayList<>();

        assertThat(points(fronts(studio))).hasSizeGreaterThan(300).allSatisfy(point -> {
            Vector3dc look = projection.direction(point.x(), point.y());
            Vector3d place = new Vector3d(look).mul(-2 / look.y()).add(from);
            assertThat(Math.hypot((place.x - 3) / 3.61248, place.z / 2.69258)).isCloseTo(1, within(0.003));
            along.add(place.x - 3);
            across.add(place.z);
        });
        assertThat(Collections.max(along)).isCloseTo(3.61248, within(0.01));
        assertThat(Collections.max(across)).isCloseTo(2.69258, within(0.01));
        assertThat(Collections.min(across)).isCloseTo(-2.69258, within(0.01));
    }

    /** The way of the light over the dust is 2007. Far away that is sqrt(T² - 4T), T after the direct light. */
    @Test
    void theLightEchoHasTheRadiusOfItsRemarks() throws IOException {
        Studio studio = BundledScenes.studio("flash-echo.json");
        Projection projection = Projection.of(studio);
        assertThat(points(fronts(studio))).hasSizeGreaterThan(300).allSatisfy(point -> {
            double radius = 2002 * Math.tan(Angles.between(projection.direction(point.x(), point.y()), AHEAD));
            assertThat(radius).isCloseTo(Math.sqrt(21), within(0.015));
            assertThat(Math.hypot(radius, 2) + Math.hypot(radius, 2002)).isCloseTo(2007, within(0.011));
        });
    }

    /** Flashes at all whole multiples of 2: at time 11 circles on a wall 2 away, cos a = 4/(11 - 2k). */
    @Test
    void eachFlashOfAPeriodHasItsFront() {
        Studio studio = studio(11, lamp(CENTRE, new Pulse(0, 0.1, 2)), wall(2));
        Projection projection = Projection.of(studio);
        List<Double> expected = Stream.of(5, 7, 9)
                .map(age -> Math.toDegrees(Math.acos(4.0 / age)))
                .toList();
        List<Double> angles = points(fronts(studio))
                .map(point -> Math.toDegrees(Angles.between(projection.direction(point.x(), point.y()), AHEAD)))
                .filter(angle -> angle < 65)
                .toList();

        assertThat(angles).allMatch(angle -> expected.stream().anyMatch(each -> Math.abs(each - angle) < 0.25));
        assertThat(expected).allMatch(each -> angles.stream().anyMatch(angle -> Math.abs(each - angle) < 0.25));
    }

    /**
     * A ball before the wall hides a part of the front, and its shadow is the part that a camera farther back misses.
     */
    @Test
    void frontsEndAtShadows() {
        Sphere ball = new Sphere("ball", new Vector3d(0.6, 0, 0.8), 0.3, DULL);
        Studio open = aimed(studio(8, lamp(CENTRE, ONCE), wall(2)), new Vector3d(0, 1, 0), AHEAD);
        Studio shaded = open.withScene(List.of(wall(2), ball));
        // seen from above, the shadow lies on the front below the ball: a ring around the lamp is cut
        double missing = 1 - length(fronts(shaded)) / length(fronts(open));
        double half = Math.toDegrees(Math.asin(0.3));

        assertThat(missing).isBetween(half / 180 / 3, 3 * half / 180);
        assertThat(fronts(open.withCamera(open.camera().withShutter(new AperturePlaneShutter(4)))))
                .isEmpty();
        assertThat(fronts(open.withScene(List.of()))).isEmpty();
        assertThat(fronts(Studios.sphere())).isEmpty();
    }

    /** In each part of a picture for two eyes there is the front that this eye sees. */
    @ParameterizedTest
    @EnumSource(
            value = StereoLayout.class,
            names = {"SIDE_BY_SIDE", "ANAGLYPH"})
    void eachEyeHasItsFront(StereoLayout layout) {
        Studio mono = studio(5, lamp(CENTRE, ONCE), wall(2));
        Studio studio = mono.withCamera(mono.camera()
                .withStereo(Descriptions.with(mono.camera().stereo().withLayout(layout), "eyeDistance", 1.0)));
        RenderPlan plan = RenderPlan.of(studio);
        List<Double> middles = Projection.ofEyes(studio).stream()
                .map(projection -> points(new Overlays(
                                        projection, SceneShapes.of(plan.world().frames()), plan)
                                .draw(OverlayKind.WAVE_FRONTS)
                                .lines())
                        .mapToDouble(Vector2dc::x)
                        .average()
                        .orElseThrow())
                .toList();
        assertThat(middles.get(0) - middles.get(1))
                .isBetween(
                        layout == StereoLayout.ANAGLYPH ? 10.0 : -299.0,
                        layout == StereoLayout.ANAGLYPH ? 200.0 : -200.0);
    }
}
