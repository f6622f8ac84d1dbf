package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.Stereo;
import tompkins.camera.StereoLayout;
import tompkins.image.LinearImage;
import tompkins.measure.Projection;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.spacetime.Event;
import tompkins.spacetime.Velocity;
import tompkins.studio.PaperStudios;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.surface.Mirror;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.world.FrameAppearance;

/** Pictures of two eyes, against closed forms of the disparity and against cameras that stand apart. */
class StereoTest {

    private static final int WIDTH = 400;
    private static final int HEIGHT = 300;
    private static final double ANGLE = 40;
    private static final double EYES = 0.6;
    private static final double NO_PARALLAX = 8;
    private static final double TIME = -3;

    private static Camera camera(StereoLayout layout) {
        return Photograph.pinhole(new Vector3d(0, 0, 1), ANGLE, TIME).withStereo(new Stereo(layout, EYES, NO_PARALLAX));
    }

    private static Studio studio(StereoLayout layout, Velocity velocity) {
        return Photograph.of(List.of(), camera(layout), velocity, WIDTH, HEIGHT).studio();
    }

    private static SceneObject wall(Vector3dc point, Vector3dc normal) {
        return new Plane("wall", point, normal, Photograph.WHITE);
    }

    /** Pixels for a slope of 1 in the picture of one eye. */
    private static double focalLength(StereoLayout layout) {
        double width = layout == StereoLayout.SIDE_BY_SIDE ? WIDTH / 2.0 : WIDTH;
        return width / 2 / Math.tan(Math.toRadians(ANGLE / 2));
    }

    /**
     * Where an eye, -1 or 1, sees a direction: its own picture is shifted by f s / (2 z0) so that z0 has no parallax.
     */
    private static Vector2d pixel(StereoLayout layout, int eye, Vector3dc seen) {
        double f = focalLength(layout);
        double x = f * (seen.x() / seen.z() + eye * EYES / 2 / NO_PARALLAX);
        double y = -f * seen.y() / seen.z();
        boolean right = eye > 0;
        return switch (layout) {
            case SIDE_BY_SIDE -> new Vector2d(WIDTH / 4.0 + (right ? WIDTH / 2.0 : 0) + x, HEIGHT / 2.0 + y);
            case TOP_AND_BOTTOM -> new Vector2d(WIDTH / 2.0 + x, HEIGHT / 4.0 + (right ? HEIGHT / 2.0 : 0) + y);
            default -> new Vector2d(WIDTH / 2.0 + x, HEIGHT / 2.0 + y);
        };
    }

    private static int[] eyes(StereoLayout layout) {
        return switch (layout) {
            case LEFT_EYE, ANAGLYPH, GREY_ANAGLYPH -> new int[] {-1};
            case RIGHT_EYE -> new int[] {1};
            case NONE -> new int[0];
            default -> new int[] {-1, 1};
        };
    }

    /** What moves with the camera has the parallax of the textbook at every speed: f s (1/z0 - 1/z). */
    @ParameterizedTest
    @EnumSource(StereoLayout.class)
    void whatMovesWithTheCameraHasItsParallax(StereoLayout layout) {
        for (Velocity velocity : List.of(Velocity.REST, Velocity.of(0, 0, 0.9), Velocity.of(0.6, -0.3, 0.5))) {
            for (double depth : new double[] {2, NO_PARALLAX, 50}) {
                Vector3d point = new Vector3d(0.05 * depth, -0.03 * depth, depth);
                RenderPlan plan = RenderPlan.of(
                        studio(layout, velocity).withCameraFrame(List.of(wall(point, new Vector3d(0, 0, 1)))));
                List<Vector2d> found = new ArrayList<>();
                for (int eye : eyes(layout)) {
                    Vector3d seen = new Vector3d(point).sub(eye * EYES / 2, 0, 0);
                    Vector2d pixel = pixel(layout, eye, seen);
                    SampleHistory life = SampleHistory.of(plan, pixel.x, pixel.y, 0, 0);
                    assertThat(life.cameraStart()).isEqualTo(new Event(eye * EYES / 2, 0, 0, TIME));
                    assertThat(life.end().event().position().distance(point)).isLessThan(1e-12);
                    found.add(pixel);
                }
                if (layout == StereoLayout.TOP_AND_BOTTOM) {
                    double disparity = focalLength(layout) * EYES * (1 / NO_PARALLAX - 1 / depth);
                    assertThat(found.get(1).x - found.get(0).x).isCloseTo(disparity, within(1e-10));
                }
            }
        }
    }

    /** Each eye is at an event of its own in the scene, and sees its light aberrated. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0, 0, 0.8", "0, 0, -0.5", "0.25, 0.1, 0", "0.3, -0.2, 0.9", "0, 0, 0.9999"})
    void whatRestsInTheSceneIsAberratedForEachEye(double x, double y, double z) {
        Velocity velocity = Velocity.of(x, y, z);
        Vector3d u = new Vector3d(x, y, z).mul(velocity.gamma());
        StereoLayout layout = StereoLayout.SIDE_BY_SIDE;
        for (double depth : new double[] {3, NO_PARALLAX, 90}) {
            Vector3d lens = scene(new Vector3d(), u);
            Vector3d point = new Vector3d(0.02, 0.01, 1).mul(depth).add(lens);
            Studio studio = studio(layout, velocity).withScene(List.of(wall(point, new Vector3d(0.1, 0.2, 1))));
            RenderPlan plan = RenderPlan.of(studio);
            List<Projection> projections = Projection.ofEyes(studio);
            for (int eye : eyes(layout)) {
                Vector3d there = scene(new Vector3d(eye * EYES / 2, 0, 0), u);
                Vector3d ahead = point.sub(there, new Vector3d()).normalize();
                Vector3d seen = new Vector3d(u)
                        .mul(u.dot(ahead) / (velocity.gamma() + 1) + 1)
                        .add(ahead);
                Vector2d pixel = pixel(layout, eye, seen);
                SampleHistory life = SampleHistory.of(plan, pixel.x, pixel.y, 0, 0);
                assertThat(life.sceneStart().position().distance(there)).isLessThan(1e-9);
                assertThat(life.end().event().position().distance(point)).isLessThan(1e-8 * depth);
                Vector2dc formula = projections.get((eye + 1) / 2).position(new FrameAppearance(studio, null), point);
                assertThat(formula.distance(pixel)).isLessThan(1e-8);
            }
        }
    }

    /** A point of the camera frame at its time, in the scene. */
    private static Vector3d scene(Vector3dc point, Vector3dc u) {
        double gamma = Math.sqrt(1 + u.lengthSquared());
        return new Vector3d(u).mul(u.dot(point) / (gamma + 1) + TIME).add(point);
    }

    private static Vector2dc position(Studio studio, int eye, Vector3dc point) {
        return Projection.ofEyes(studio).get(eye).position(new FrameAppearance(studio, null), point);
    }

    private static Studio paper(Camera camera, int samples) {
        Studio studio = PaperStudios.fig1b();
        return studio.withCamera(camera)
                .withSettings(studio.settings().withSize(120, 90).withSamples(samples));
    }

    private static LinearImage image(Camera camera, int samples) {
        return new Photograph(paper(camera, samples)).image();
    }

    /** Infinitely far away both pictures agree; each is then that of an ordinary camera at the place of the eye. */
    @Test
    void eyesAreCamerasThatStandApart() {
        Camera camera = PaperStudios.fig3a().camera();
        Camera both = camera.withStereo(new Stereo(StereoLayout.SIDE_BY_SIDE, EYES, 1e50));
        LinearImage left = image(CameraMotion.shifted(camera, new Vector3d(-EYES / 2, 0, 0)), 4);
        LinearImage right = image(CameraMotion.shifted(camera, new Vector3d(EYES / 2, 0, 0)), 4);
        Studio wide = paper(both, 4);
        LinearImage pair = new Photograph(wide.withSettings(wide.settings().withSize(240, 90))).image();
        assertSame(pair, 0, 0, left);
        assertSame(pair, 120, 0, right);
        Studio high = paper(both.withStereo(both.stereo().withLayout(StereoLayout.TOP_AND_BOTTOM)), 4);
        LinearImage stack = new Photograph(high.withSettings(high.settings().withSize(120, 181))).image();
        assertSame(stack, 0, 0, left);
        assertSame(stack, 0, 90, right);
    }

    /** Stars are put into pixels by the place of each eye's own centre rays, also behind a mirror. */
    @Test
    void eachEyeHasItsOwnStars() {
        SceneObject mirror = new Parallelogram(
                "mirror", new Vector3d(-1, -1, 4), new Vector3d(1, 0, 0), new Vector3d(0, 2, 0), Mirror.DEFAULT);
        Camera camera = camera(StereoLayout.SIDE_BY_SIDE);
        Studio sky = Descriptions.with(Studio.DEFAULT, "background", StarSky.DEFAULT)
                .withScene(List.of(mirror))
                .withVelocity(Velocity.of(0.1, 0, 0.8));
        LinearImage left = stars(sky, camera, StereoLayout.LEFT_EYE, 120);
        LinearImage right = stars(sky, camera, StereoLayout.RIGHT_EYE, 120);
        LinearImage pair = stars(sky, camera, StereoLayout.SIDE_BY_SIDE, 240);
        LinearImage both = stars(sky, camera, StereoLayout.ANAGLYPH, 120);
        assertSame(pair, 0, 0, left);
        assertSame(pair, 120, 0, right);
        assertThat(left.rgb()).isNotEqualTo(right.rgb());
        for (int i = 0; i < both.rgb().length; i++) {
            assertThat(both.rgb()[i]).isEqualTo((i % 3 == 0 ? left : right).rgb()[i]);
        }
    }

    private static LinearImage stars(Studio sky, Camera camera, StereoLayout layout, int width) {
        Studio studio = sky.withCamera(camera.withStereo(camera.stereo().withLayout(layout)))
                .withSettings(sky.settings().withSize(width, 90).withSamples(2));
        return new Photograph(studio).image();
    }

    private static void assertSame(LinearImage whole, int column, int row, LinearImage part) {
        for (int y = 0; y < part.height(); y++) {
            for (int x = 0; x < part.width(); x++) {
                for (int channel = 0; channel < 3; channel++) {
                    assertThat(whole.value(column + x, row + y, channel)).isEqualTo(part.value(x, y, channel));
                }
            }
        }
    }

    /** Red is that of the left eye, green and blue are those of the right eye; or the luminance of each. */
    @ParameterizedTest
    @EnumSource(names = {"ANAGLYPH", "GREY_ANAGLYPH"})
    void anaglyphsCombineBothEyes(StereoLayout layout) {
        double[] grey = {.2126, .7152, .0722};
        double[][] weights = layout == StereoLayout.ANAGLYPH
                ? new double[][] {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}
                : new double[][] {grey, grey, grey};
        Camera camera = PaperStudios.fig3a().camera();
        Stereo stereo = new Stereo(layout, EYES, NO_PARALLAX);
        LinearImage left = image(camera.withStereo(stereo.withLayout(StereoLayout.LEFT_EYE)), 4);
        LinearImage right = image(camera.withStereo(stereo.withLayout(StereoLayout.RIGHT_EYE)), 4);
        LinearImage both = image(camera.withStereo(stereo), 4);
        assertThat(left.rgb()).isNotEqualTo(right.rgb());
        for (int y = 0; y < both.height(); y++) {
            for (int x = 0; x < both.width(); x++) {
                for (int channel = 0; channel < 3; channel++) {
                    LinearImage eye = channel == 0 ? left : right;
                    double expected = 0;
                    for (int from = 0; from < 3; from++) {
                        expected += weights[channel][from] * eye.value(x, y, from);
                    }
                    double tolerance = layout == StereoLayout.ANAGLYPH ? 0 : 1e-6;
                    assertThat((double) both.value(x, y, channel)).isCloseTo(expected, within(tolerance));
                }
            }
        }
    }

    /** An eye of a panorama looks along a tangent of the circle on which it turns. */
    @ParameterizedTest
    @CsvSource({"0.4, 0, 0, 0", "0.4, 0.7, -0.2, 0.5", "3, 0, 0, 0.9", "50, -0.5, 0.1, -0.6"})
    void eyesOfPanoramasTurn(double distance, double x, double y, double z) {
        Velocity velocity = Velocity.of(x, y, z);
        StereoLayout layout = StereoLayout.TOP_AND_BOTTOM;
        Camera camera = PanoramicCamera.DEFAULT.withStereo(new Stereo(layout, EYES, NO_PARALLAX));
        double height = 0.7;
        for (double longitude : new double[] {-3.1, -1, 0, 0.3, 2, 3.14}) {
            Vector3d point = new Vector3d(distance * Math.sin(longitude), height, distance * Math.cos(longitude));
            Studio studio = Photograph.of(List.of(), camera, velocity, 720, 720)
                    .studio()
                    .withCameraFrame(List.of(wall(point, point)));
            RenderPlan plan = RenderPlan.of(studio);
            for (int eye : eyes(layout)) {
                double aside = -eye * (Math.asin(EYES / 2 / distance) - Math.asin(EYES / 2 / NO_PARALLAX));
                double column = 360 + Math.toDegrees(longitude + aside) * 2;
                double latitude = Math.atan2(height, Math.sqrt(distance * distance - EYES * EYES / 4));
                double row = 180 - Math.toDegrees(latitude) * 2 + (eye > 0 ? 360 : 0);
                SampleHistory life = SampleHistory.of(plan, column, row, 0, 0);
                assertThat(life.cameraStart().position().length()).isCloseTo(EYES / 2, within(1e-12));
                assertThat(life.cameraStart().time()).isZero();
                assertThat(life.end().event().position().distance(point)).isLessThan(1e-10 * distance);
            }
        }
    }

    /** The formula for what overlays show takes the same way. */
    @Test
    void overlaysFollowTheEyesOfPanoramas() {
        Camera camera = PanoramicCamera.DEFAULT.withStereo(new Stereo(StereoLayout.SIDE_BY_SIDE, EYES, 1e50));
        Studio studio =
                Photograph.of(List.of(), camera, Velocity.REST, 1440, 360).studio();
        Vector3d point = new Vector3d(0, 0, 0.5);
        assertThat(position(studio, 0, point).x()).isCloseTo(360 + 2 * Math.toDegrees(Math.asin(0.6)), within(1e-6));
        assertThat(position(studio, 1, point).x()).isCloseTo(1080 - 2 * Math.toDegrees(Math.asin(0.6)), within(1e-6));
    }

    @Test
    void impossibleEyesAreRefused() {
        assertThatThrownBy(() -> new Stereo(StereoLayout.ANAGLYPH, 2, 1))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessage("zeroParallaxDistance must be more than half the eyeDistance 2, was 1");
        assertThatThrownBy(() -> new Stereo(StereoLayout.ANAGLYPH, -1, 1))
                .hasMessage("eyeDistance must be from 0 to 1e50, was -1");
        Camera panorama = PanoramicCamera.DEFAULT.withShutter(new FocusSurfaceShutter(0));
        assertThatThrownBy(() -> panorama.withStereo(new Stereo(StereoLayout.TOP_AND_BOTTOM, 1, 10)))
                .hasMessageStartingWith("shutter must be AperturePlaneShutter, because the eyes of a panorama turn")
                .hasMessageEndingWith("was FocusSurfaceShutter");
        assertThatThrownBy(() -> Descriptions.with(
                        camera(StereoLayout.SIDE_BY_SIDE),
                        "focus",
                        wall(new Vector3d(EYES / 2, 0, 5), new Vector3d(1, 0, 0))))
                .hasMessageContaining("does not pass through the lens centre [0.3, 0, 0]");
    }
}
