package tompkins.explain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.Camera;
import tompkins.camera.FieldOfView;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;
import tompkins.trace.RenderPlan;

/** How far things move in the picture while the shutter is open, against the closed form for a wall that is passed. */
class MotionBlurTest {

    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    private static final double DEPTH = 10;
    private static final double PER_PIXEL = 2 * Math.tan(Math.toRadians(25)) / WIDTH;

    private static Studio wall(double speed, double exposure, RollingShutter rolling) {
        SceneObject wall = new Plane("wall", new Vector3d(0, 0, DEPTH), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
        Camera instant = FieldOfView.with(ThinLensCamera.DEFAULT, 50).withShutter(new AperturePlaneShutter(3));
        Camera camera =
                Descriptions.with(Descriptions.with(instant, "exposureTime", exposure), "rollingShutter", rolling);
        return Studio.DEFAULT
                .withScene(List.of(wall))
                .withVelocity(Velocity.of(speed, 0, 0))
                .withCamera(camera)
                .withSettings(Studio.DEFAULT.settings().withSize(WIDTH, HEIGHT));
    }

    /**
     * A point of the wall is seen at X with X Z = x0 - v (t - Z sqrt(1 + X^2 + Y^2)), so that X changes by -v dt/(Z (1
     * - v X/sqrt(1 + X^2 + Y^2))).
     */
    private static double length(double speed, double exposure, int column, int row) {
        double x = (column + 0.5 - WIDTH / 2.0) * PER_PIXEL;
        double y = (row + 0.5 - HEIGHT / 2.0) * PER_PIXEL;
        return speed * exposure / (DEPTH * (1 - speed * x / Math.sqrt(1 + x * x + y * y))) / PER_PIXEL;
    }

    private static double inTheMiddle(RenderPlan plan) {
        return MotionBlur.length(plan, plan.middle().x(), plan.middle().y());
    }

    private static double atPixel(RenderPlan plan, int column, int row) {
        return MotionBlur.length(plan, column + 0.5, row + 0.5);
    }

    @ParameterizedTest
    @CsvSource({"0.001, 100", "0.5, 0.4", "0.9, 0.1"})
    void lengthsAreThoseOfTheClosedForm(double speed, double exposure) {
        RenderPlan plan = RenderPlan.of(wall(speed, exposure, RollingShutter.DEFAULT));
        double middle = length(speed, exposure, WIDTH / 2, HEIGHT / 2);
        double corner = length(speed, exposure, WIDTH - 1, HEIGHT - 1);
        assertThat(corner).isGreaterThanOrEqualTo(middle);
        assertThat(inTheMiddle(plan)).isCloseTo(middle, within(0.01 * middle));
        assertThat(atPixel(plan, WIDTH - 1, HEIGHT - 1)).isCloseTo(corner, within(0.02 * corner));
        assertThat(new Explanation(RenderPlan.of(wall(speed, exposure, RollingShutter.DEFAULT))).sentences())
                .anyMatch(sentence -> sentence.startsWith("The shutter stays open for "));
    }

    /** A wall that passes the camera blurs as one that the camera passes, also if two motions make its velocity. */
    @Test
    void movingThingsBlurAsForAMovingCamera() {
        double half = 0.5;
        double speed = 2 * half / (1 + half * half);
        Studio rest = wall(0, 0.2, RollingShutter.DEFAULT);
        Velocity velocity = Velocity.of(-half, 0, 0);
        SceneObject inner = new Moving("inner", velocity, new Vector3d(), 0, rest.scene());
        SceneObject outer = new Moving("outer", velocity, new Vector3d(0.3, 0, 0), 0, List.of(inner));
        RenderPlan plan = RenderPlan.of(rest.withScene(List.of(outer)));
        double middle = length(speed, 0.2, WIDTH / 2, HEIGHT / 2);
        double corner = length(speed, 0.2, WIDTH - 1, HEIGHT - 1);
        assertThat(inTheMiddle(plan)).isCloseTo(middle, within(0.01 * middle));
        assertThat(atPixel(plan, WIDTH - 1, HEIGHT - 1)).isCloseTo(corner, within(0.02 * corner));
    }

    /** A shutter that rolls after what moves sees it longer: 1/(1 - speed in pictures per sweep) times as far. */
    @Test
    void rollingShutterStretchesTheBlur() {
        double sweep = 2;
        double speed = 0.1;
        double motion = length(speed, 1, WIDTH / 2, HEIGHT / 2) * sweep / WIDTH;
        RenderPlan plan = RenderPlan.of(wall(speed, 0.2, new RollingShutter(SweepDirection.LEFT, sweep)));
        double instant = length(speed, 0.2, WIDTH / 2, HEIGHT / 2);
        assertThat(inTheMiddle(plan)).isCloseTo(instant / (1 - motion), within(0.01 * instant));
    }

    /** A wall that passes upwards, seen above its middle: the same closed form with y for x. */
    @Test
    void rowsCountAsColumnsDo() {
        Studio upright = wall(0.9, 0.1, RollingShutter.DEFAULT).withVelocity(Velocity.of(0, 0.9, 0));
        RenderPlan plan = RenderPlan.of(upright);
        double middle = 0.9 * 0.1 / DEPTH / PER_PIXEL;
        double y = HEIGHT / 2.0 * PER_PIXEL;
        double top = middle / (1 - 0.9 * y / Math.sqrt(1 + y * y));
        assertThat(inTheMiddle(plan)).isCloseTo(middle, within(0.01 * middle));
        assertThat(atPixel(plan, WIDTH / 2, 0)).isCloseTo(top, within(0.01 * top));
    }

    /** The mirror rests, and what is seen in it moves: only the mirror has a place in the picture. */
    @Test
    void whatIsSeenInAMirrorIsNotMeasured() {
        Studio wall = wall(0, 0.2, RollingShutter.DEFAULT);
        SceneObject mirror = new Plane("mirror", new Vector3d(0, 0, 3), new Vector3d(0, 0, 1), Mirror.DEFAULT);
        SceneObject behind =
                new Plane("behind", new Vector3d(0, 0, -4), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
        SceneObject passing = new Moving("passing", Velocity.of(0.5, 0, 0), new Vector3d(), 0, List.of(behind));
        RenderPlan plan = RenderPlan.of(wall.withScene(List.of(mirror, passing)));
        assertThat(inTheMiddle(plan)).isCloseTo(0, within(1e-9));
    }

    /** The speed of a rim is not that of its axis. */
    @Test
    void whatTurnsIsNotMeasured() {
        Studio wall = wall(0, 0.2, RollingShutter.DEFAULT);
        assertThat(inTheMiddle(RenderPlan.of(wall.withScene(List.of(Rotating.DEFAULT)))))
                .isNaN();
    }

    @Test
    void skyAndCompanionsStaySharp() {
        Studio empty = wall(0.5, 1, RollingShutter.DEFAULT).withScene(List.of());
        assertThat(inTheMiddle(RenderPlan.of(empty))).isZero();
        Studio companion = empty.withCameraFrame(
                List.of(new Plane("sheet", new Vector3d(0, 0, 5), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT)));
        assertThat(inTheMiddle(RenderPlan.of(companion))).isZero();
    }

    @Test
    void restHasNothingToSay() {
        List<String> sentences =
                new Explanation(RenderPlan.of(wall(0, 1, new RollingShutter(SweepDirection.UP, 2)))).sentences();
        assertThat(sentences).noneMatch(sentence -> sentence.contains("stays open") || sentence.contains("rolls"));
    }
}
