package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.ThinLensCamera;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** The numbers that the scenes with long exposures and rolling shutters tell in their remarks, measured on rays. */
class ExposureScenesTest {

    private static final int WIDTH = 4000;
    private static final int HEIGHT = 3000;
    private static final int MOMENTS = 500;

    /** A scene, and where in its picture the directions (x, y, 1) of the camera lie. */
    private static final class Shown {

        private final RenderPlan plan;
        private final double edge;

        Shown(String scene) {
            Studio studio = SceneFiles.read(scene);
            plan = RenderPlan.of(studio.withSettings(studio.settings().withSize(WIDTH, HEIGHT)));
            edge = Math.tan(Math.toRadians(((ThinLensCamera) studio.camera()).horizontalAngleDegrees() / 2));
        }

        SampleHistory ray(double x, double y, double moment) {
            return SampleHistory.of(plan, WIDTH / 2.0 * (1 + x / edge), row(y), 0, 0, moment);
        }

        private double row(double y) {
            return HEIGHT / 2.0 * (1 - y / (0.75 * edge));
        }

        /**
         * The direction of the middle of the row of pixels that a direction lies in, and the part of the rows above.
         */
        double middleOfRow(double y) {
            return 0.75 * edge * (1 - 2 * partAbove(y));
        }

        double partAbove(double y) {
            return (Math.floor(row(y)) + 0.5) / HEIGHT;
        }

        boolean meets(String name, double x, double y, double moment) {
            SampleHistory life = ray(x, y, moment);
            return life.end() != null && life.end().object().description().equals(name);
        }

        /** The mean over the exposure time. */
        double mean(double x, double y, ToDoubleFunction<SampleHistory> value) {
            double sum = 0;
            for (int i = 0; i < MOMENTS; i++) {
                sum += value.applyAsDouble(ray(x, y, (i + 0.5) / MOMENTS));
            }
            return sum / MOMENTS;
        }

        /** Where, from one direction to a greater one, an object ends that is met at the first. */
        double end(String name, double from, double to, double y) {
            double inside = from;
            double outside = to;
            assertThat(meets(name, inside, y, 0.5)).isTrue();
            while (Math.abs(outside - inside) > 1e-9) {
                double middle = (inside + outside) / 2;
                if (meets(name, middle, y, 0.5)) {
                    inside = middle;
                } else {
                    outside = middle;
                }
            }
            return inside;
        }
    }

    private static double brightnessOfDial(Shown shown, double degrees) {
        double angle = Math.toRadians(degrees);
        double radius = 0.3 * 2.2;
        return shown.mean(
                radius * Math.sin(angle) / 10,
                (0.65 + radius * Math.cos(angle)) / 10,
                life -> life.colour().red());
    }

    /**
     * A quarter of a turn in 1.5: at three tenths of the width of the dial the hand, 0.06 of it wide, hides each point
     * for the share 2 asin(0.1)/(pi/2) of that, and shows a ninth of the light.
     */
    @ParameterizedTest
    @ValueSource(doubles = {12, 45, 80})
    void handSweepsAQuarterOfTheDial(double degrees) {
        Shown shown = new Shown("long-exposure");
        double dial = brightnessOfDial(shown, 225);
        double hidden = 2 * Math.asin(0.1) / (Math.PI / 2);

        assertThat(brightnessOfDial(shown, degrees) / dial).isCloseTo(1 - hidden * 8 / 9, within(0.002));
    }

    @ParameterizedTest
    @ValueSource(doubles = {105, 180, 270, 345})
    void handLeavesTheRestOfTheDial(double degrees) {
        Shown shown = new Shown("long-exposure");

        assertThat(brightnessOfDial(shown, degrees)).isCloseTo(brightnessOfDial(shown, 225), within(1e-3));
    }

    /**
     * The part of the exposure for which the rod is seen: from when its front end comes into the way of the light until
     * its rear end, which is seen as deep as the way is long within the rod, leaves it.
     */
    private static double seenShare(double x, double y) {
        // where the way is 0.12 away from the axis
        double half = 10 - 0.9 * y;
        double square = 1 + y * y;
        double root = Math.sqrt(half * half - square * (100 + 0.81 - 0.12 * 0.12));
        double first = passage(x, y, (half - root) / square, 1);
        double last = passage(x, y, (half + root) / square, -1);
        return Math.max(0, Math.min(1.5, last) - Math.max(0, first)) / 1.5;
    }

    /** When light comes from an end of the rod, the front one (1) or the rear one (-1), at a depth. */
    private static double passage(double x, double y, double depth, int end) {
        // the middle of the rod is at -0.675 + 0.9 t
        double time = (x * depth - end * Math.sqrt(1 - 0.81) + 0.675) / 0.9;
        return time + depth * Math.sqrt(1 + x * x + y * y) - 10;
    }

    /** Near its upper edge the rod is as good as thin: there it is seen for 0.87/1.35 of the time, in the middle. */
    @Test
    void rodIsSeenForItsShareOfTheExposure() {
        Shown shown = new Shown("long-exposure");
        double y = -Math.tan(Math.atan(0.09) - Math.asin(0.9995 * 0.12 / Math.hypot(0.9, 10)));
        double plateau = 0;
        double step = 0.002;
        for (double x = -0.15; x < 0.15; x += step) {
            double share =
                    shown.mean(x, y, life -> life.end().object().description().equals("rod") ? 1 : 0);
            assertThat(share).as("x = %s", x).isCloseTo(seenShare(x, y), within(0.003));
            plateau += share > 0.64 ? 10 * step : 0;
        }
        assertThat(seenShare(0, y)).isCloseTo(0.646, within(0.01));
        assertThat(plateau).isCloseTo(0.48, within(0.03));
    }

    /**
     * X Z = x0/gamma - v (t - Z sqrt(1 + X² + Y²)): where an upright edge at x0 in the scene is seen in the row that
     * opens at t.
     */
    private static double edgeAt(double x0, double depth, double v, double time, double y) {
        double x = 0;
        for (int i = 0; i < 100; i++) {
            x = (x0 * Math.sqrt(1 - v * v) - v * (time - depth * Math.sqrt(1 + x * x + y * y))) / depth;
        }
        return x;
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.11, -0.05, 0.03, 0.1, 0.17})
    void boardsLeanByTheWayOfTheCamera(double height) {
        Shown shown = new Shown("rolling-fence");
        double y = shown.middleOfRow(height);
        double expected = edgeAt(-0.25, 10, 0.5, 8 + 4 * shown.partAbove(height), y);

        assertThat(shown.end("board", expected + 0.01, expected - 0.02, y)).isCloseTo(expected, within(1e-6));
    }

    /** Between rows as far above the middle as below it, the way of the light makes no difference. */
    @Test
    void leanOfABoardIsAFifthOfItsDistance() {
        Shown shown = new Shown("rolling-fence");
        double upper = shown.middleOfRow(0.1);
        double lower = -upper;
        double above = edgeAt(-0.25, 10, 0.5, 8 + 4 * shown.partAbove(upper), upper);
        double below = edgeAt(-0.25, 10, 0.5, 8 + 4 * shown.partAbove(lower), lower);

        double lean = (shown.end("board", above + 0.01, above - 0.02, upper)
                        - shown.end("board", below + 0.01, below - 0.02, lower))
                / (shown.partAbove(lower) - shown.partAbove(upper));

        assertThat(lean).isCloseTo(0.5 * 4 / 10, within(0.003));
    }

    /** In the middle of its exposure of 0.15 a row is open as for an instant. */
    private static double edgeBeforeSlit(Shown shown, double x0, double depth, double y) {
        return edgeAt(x0, depth, -0.3, 8 + 0.075 + 4 * (1 - shown.partAbove(y)), y);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.015, 0.04})
    void carLeansByTheWayOfTheCamera(double height) {
        Shown shown = new Shown("rolling-slit");
        double y = shown.middleOfRow(height);
        double expected = edgeBeforeSlit(shown, 2.1, 9.85, y);

        assertThat(shown.end("body", expected - 0.003, expected + 0.02, y)).isCloseTo(expected, within(1e-6));
    }

    /**
     * A post leans by v sweep/(Z (1 - v X/sqrt(1 + X² + Y²))) with Z = 14, where something as far away as the car has
     * 9.85.
     */
    @Test
    void whatIsFarAwayLeansLess() {
        Shown shown = new Shown("rolling-slit");
        double upper = shown.middleOfRow(0.06);
        double lower = -upper;
        double above = edgeBeforeSlit(shown, 4.8, 14, upper);
        double below = edgeBeforeSlit(shown, 4.8, 14, lower);

        double lean = (shown.end("post", above, above + 0.02, upper) - shown.end("post", below, below + 0.02, lower))
                / (shown.partAbove(lower) - shown.partAbove(upper));

        double x = (above + below) / 2;
        assertThat(lean).isCloseTo(0.3 * 4 / 14 / (1 + 0.3 * x / Math.sqrt(1 + x * x + upper * upper)), within(0.001));
    }
}
