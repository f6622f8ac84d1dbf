package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.DoublePredicate;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.camera.ThinLensCamera;
import tompkins.explain.Flashes;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;
import tompkins.trace.RenderPlan;

/** Where closed formulas say that the light of a flash is at a time. */
class FlashFactsTest {

    private static final ColouredSurface DULL = new ColouredSurface(Colour.WHITE, Colour.BLACK);
    private static final Vector3dc DOWN = new Vector3d(0, -1, 0);
    private static final Vector3dc CENTRE = new Vector3d();
    private static final Pulse LONG = new Pulse(0, 1e6, 0);

    private static final SceneObject FLOOR = new Plane("floor", CENTRE, new Vector3d(0, 1, 0), DULL);

    private static PointLight lamp(Vector3dc place, Pulse flash) {
        return new PointLight(place, Colour.WHITE, Colour.BLACK, 1, flash);
    }

    private static LightSource moving(double vx, double vz, Vector3dc place, PointLight lamp) {
        return new MovingLights(Velocity.of(vx, 0, vz), place, List.of(lamp));
    }

    private static Studio studio(SceneObject object, LightSource lamp) {
        return Lighting.of(Studios.dark().withScene(List.of(object)), List.of(lamp))
                .withSettings(Studio.DEFAULT.settings().withSize(3, 3));
    }

    /** Whether a camera at a place that looks in a direction at a time of its frame sees light there. */
    private static boolean isLit(Studio studio, Vector3dc from, Vector3dc view, double time) {
        ThinLensCamera camera = Photograph.pinhole(view, 1, time);
        return new Photograph(studio.withCamera(Descriptions.with(camera, "position", from)))
                        .trace(1.5, 1.5)
                        .colour()
                        .red()
                > 0;
    }

    /** Where light ends between a number at which there is some and one at which there is none. */
    private static double edge(double lit, double dark, DoublePredicate isLit) {
        assertThat(isLit.test(lit)).isTrue();
        assertThat(isLit.test(dark)).isFalse();
        double one = lit;
        double other = dark;
        while (Math.abs(one - other) > 1e-9) {
            double middle = (one + other) / 2;
            if (isLit.test(middle)) {
                one = middle;
            } else {
                other = middle;
            }
        }
        return one;
    }

    private static Vector3d tilted(double degrees) {
        double angle = Math.toRadians(degrees);
        return new Vector3d(Math.sin(angle), 0, Math.cos(angle));
    }

    /** Lamp and camera at height 2 and 6 apart, at time 9: an ellipse with half axes 3.61248 and 2.69258. */
    @Test
    void floorIsLitWithinAnEllipse() {
        Studio studio = studio(FLOOR, lamp(new Vector3d(6, 2, 0), LONG));
        Vector3d camera = new Vector3d(0, 2, 0);
        double along = edge(3, 9, x -> isLit(studio, camera, new Vector3d(x, -2, 0), 9));
        double across = edge(0, 9, z -> isLit(studio, camera, new Vector3d(3, -2, z), 9));

        assertThat(along - 3).isCloseTo(3.61248, within(1e-5));
        assertThat(across).isCloseTo(2.69258, within(1e-5));
        assertThat(isLit(studio, camera, new Vector3d(3, -2, 0), 7.2112)).isTrue();
        assertThat(isLit(studio, camera, new Vector3d(3, -2, 0), 7.2110)).isFalse();
    }

    /** A lamp at height 2, time 5: the measured view of a camera at rest shows a circle of radius 4.58258. */
    @ParameterizedTest
    @EnumSource(value = TransformationLaw.class)
    void measuredRingIsACircle(TransformationLaw law) {
        Studio studio = studio(FLOOR, lamp(new Vector3d(0, 2, 0), LONG))
                .withView(View.MEASURED)
                .withTransformation(law);
        double radius = edge(0, 9, x -> isLit(studio, new Vector3d(1, 7, 0), new Vector3d(x - 1, -7, 0), 5));
        assertThat(radius).isCloseTo(4.58258, within(1e-5));
    }

    /** The lamp at the camera, a wall 2 or 1.5 away, time 5: a circle; a camera that flies through sees it smaller. */
    @ParameterizedTest
    @CsvSource({"2, 0, 36.8699", "1.5, 0, 53.1301", "1.5, 0.6, 28.0725"})
    void circleOnAWallIsAberrated(double distance, double speed, double degrees) {
        Studio studio = studio(wall(distance), lamp(CENTRE, LONG)).withVelocity(Velocity.of(0, 0, speed));
        double gamma = 1 / Math.sqrt(1 - speed * speed);
        Vector3d lens = new Vector3d(0, 0, -gamma * speed * 5);
        assertThat(edge(0, 80, angle -> isLit(studio, lens, tilted(angle), gamma * 5)))
                .isCloseTo(degrees, within(1e-4));
    }

    private static Plane wall(double distance) {
        return new Plane("wall", new Vector3d(0, 0, distance), new Vector3d(0, 0, -1), DULL);
    }

    /**
     * A camera with a lamp of its own at 0.6, a wall 10 away: light from 10 on, at time T within cos = 20/(gamma T) -
     * 0.6.
     */
    @Test
    void ownLampLightsAWallAhead() {
        Studio studio =
                studio(wall(10), moving(0, 0.6, CENTRE, lamp(CENTRE, LONG))).withVelocity(Velocity.of(0, 0, 0.6));
        assertThat(edge(12, 5, time -> isLit(studio, CENTRE, tilted(0), time))).isCloseTo(10, within(1e-6));
        assertThat(edge(0, 80, angle -> isLit(studio, CENTRE, tilted(angle), 12)))
                .isCloseTo(Math.toDegrees(Math.acos(2 * 10 / (1.25 * 12) - 0.6)), within(1e-4));
    }

    /** A lamp at height 3 with 0.6 flashes for 1 of its time: at 8 a ring, narrow ahead and wide behind. */
    @ParameterizedTest
    @CsvSource({"7, 9, 7.41620", "7, 0, 6.79669", "-6, -9, -7.41620", "-6, 0, -5.29669"})
    void ringOfAMovingLampRests(double lit, double dark, double x) {
        Studio studio = studio(FLOOR, moving(0.6, 0, new Vector3d(0, 3, 0), lamp(CENTRE, new Pulse(0, 1, 0))));
        assertThat(edge(lit, dark, at -> isLit(studio, new Vector3d(at, 1e-7, 0), DOWN, 8)))
                .isCloseTo(x, within(1e-5));
    }

    /** The flash of the camera's own lamp on a ball of radius 1 whose centre is 10 away. */
    @Test
    void echoOfABallIsARing() {
        Studio studio = studio(new Sphere("ball", new Vector3d(0, 0, 10), 1, DULL), lamp(CENTRE, LONG));
        assertThat(edge(19, 17, time -> isLit(studio, CENTRE, tilted(0), time))).isCloseTo(18, within(1e-6));
        assertThat(edge(0, 5.7, angle -> isLit(studio, CENTRE, tilted(angle), 19)))
                .isCloseTo(5.09254, within(1e-5));
    }

    /** Einstein's train: both lamps flash at own time 0, on the embankment at x = -1.25 and at x = 1.25. */
    @ParameterizedTest
    @CsvSource({"-1, 0, 0.5", "1, 0, 2", "-1, 0.75, 1.25", "1, 0.75, 1.25"})
    void trainIsLitAtDifferentTimes(double own, double x, double time) {
        Studio studio = studio(FLOOR, moving(0.6, 0, CENTRE, lamp(new Vector3d(own, 1e-6, 0), LONG)));
        assertThat(edge(9, -9, t -> isLit(studio, new Vector3d(x, 1e-6, 0), DOWN, t)))
                .isCloseTo(time, within(1e-5));
    }

    /** In a mirror what is lit is seen by its own event: 3 to the floor, 2 more over the mirror to the camera. */
    @Test
    void mirrorShowsTheLightOfItsOwnTime() {
        Disc mirror = new Disc("mirror", new Vector3d(5, 4, 0), new Vector3d(0, -1, 0), 1, new Mirror(1));
        Studio studio = studio(FLOOR, lamp(new Vector3d(5, 3, 0.001), new Pulse(0, 0.5, 0)))
                .withScene(List.of(FLOOR, mirror));
        Vector3d camera = new Vector3d(5, 3.999, 0.1);
        Vector3d up = new Vector3d(0, 1, 0);
        assertThat(edge(7.2, 6.8, time -> isLit(studio, camera, up, time))).isCloseTo(7.0017, within(1e-3));
    }

    /** What moves with the camera is lit as if the lamp rested there, by the clock of the camera frame. */
    @Test
    void objectsBeforeTheLensHaveTheCamerasTime() {
        Disc screen = new Disc("screen", new Vector3d(0, 0, 4), new Vector3d(0, 0, -1), 1, DULL);
        Studio studio = studio(FLOOR, moving(0, 0.6, CENTRE, lamp(CENTRE, LONG)))
                .withCameraFrame(List.of(screen))
                .withVelocity(Velocity.of(0.8, 0, 0));
        assertThat(edge(9, 7, time -> isLit(studio, CENTRE, tilted(0), time))).isCloseTo(8, within(1e-6));
    }

    /** Light has speed 1 in the frame of the camera, in which lamp and wall move with -0.5. */
    @Test
    void galileanLightGoesWithTheCamera() {
        double speed = 0.5;
        Studio studio = studio(wall(4), lamp(CENTRE, LONG))
                .withTransformation(TransformationLaw.GALILEAN)
                .withVelocity(Velocity.of(0, 0, speed));
        // the wall comes towards the light, which meets it as far away as it then has to come back
        double toWall = 4 / (1 + speed);
        double time = toWall + 4 - speed * toWall;
        assertThat(edge(6, 0, t -> isLit(studio, CENTRE, tilted(0), t))).isCloseTo(time, within(1e-6));
    }

    /** Late or far away, a picture is that of the same flash here and now. */
    @ParameterizedTest
    @CsvSource({"0, 0", "0, 5000", "0.6, 0", "0.6, 50000"})
    void flashesLongAfterAreTheSame(double speed, double later) {
        Studio studio = studio(
                        new Plane("wall", new Vector3d(0, 3, 0), new Vector3d(0, -1, 0), DULL),
                        moving(speed, 0, CENTRE, lamp(CENTRE, new Pulse(later, 0.5, 0))))
                .withVelocity(Velocity.of(speed, 0, 0));
        Vector3d up = new Vector3d(0, 1, 0);
        assertThat(edge(later + 6.2, later + 5.8, time -> isLit(studio, CENTRE, up, time)) - later)
                .isCloseTo(6, within(1e-6));
        assertThat(edge(later + 6.2, later + 6.7, time -> isLit(studio, CENTRE, up, time)) - later)
                .isCloseTo(6.5, within(1e-6));
    }

    /** The picture of a long exposure has the share of the light: a flash of 0.5 in an exposure of 2. */
    @Test
    void exposureIsTheShareOfTheLight() {
        Studio studio = studio(wall(2), lamp(CENTRE, new Pulse(0, 0.5, 0)));
        ThinLensCamera camera = Photograph.pinhole(new Vector3d(0, 0, 1), 1, 3);
        Studio exposed = studio.withCamera(camera.withExposureTime(2))
                .withSettings(studio.settings().withSamples(64));

        assertThat(RenderPlan.of(exposed).blursInTime()).isTrue();
        assertThat(new Photograph(exposed).image().value(1, 1, 0)).isCloseTo(0.25f, within(1 / 64f));
    }

    /** From the first light to the last in sight, for the window: a wall 2 away, seen up to 45 degrees. */
    @Test
    void litTimesOfThePicture() {
        Studio studio = studio(wall(2), lamp(CENTRE, new Pulse(0, 0.5, 0)))
                .withCamera(Photograph.pinhole(new Vector3d(0, 0, 1), 90, 100));
        assertThat(new Flashes(RenderPlan.of(studio)).litTimes()).hasValueSatisfying(times -> {
            assertThat(times.from()).isCloseTo(4, within(0.05));
            assertThat(times.to()).isBetween(6.0, 0.5 + 4 * Math.sqrt(3));
        });
        assertThat(new Flashes(RenderPlan.of(Studios.sphere())).litTimes()).isEmpty();
    }
}
