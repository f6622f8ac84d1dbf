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
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.ColouredSurface;
import tompkins.trace.RenderPlan;

/** Where closed formulas say that the light of a flash is at a time. */
class FlashFactsTest {

    private static final ColouredSurface DULL = new ColouredSurface(Colour.WHITE, Colour.BLACK);
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

    private static Plane wall(double distance) {
        return new Plane("wall", new Vector3d(0, 0, distance), new Vector3d(0, 0, -1), DULL);
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
