package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.ThinLensCamera;
import tompkins.image.ToneCurve;
import tompkins.light.ColourLaw;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.spacetime.Velocity;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.UniformBackground;
import tompkins.trace.RenderPlan;

/**
 * A sky of one brightness, seen straight ahead: its brightness falls by the fourth power of the Doppler factor, so that
 * the pixels that a screen cannot show are counted by a closed formula.
 */
class ClippingTest {

    private static final int WIDTH = 80;
    private static final int HEIGHT = 60;
    private static final double SKY = 0.5;

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.99, 0.9999, 0.999999})
    void blackPixelsAreCounted(double speed) throws InterruptedException {
        RenderReport report = render(sky(speed, 0));
        long black = pixels(speed, light -> light < 1 / 255.0);
        assertThat(report.clipping().black()).isEqualTo(black);
        assertThat(report.clipping().white()).isZero();
        assertThat(report.warnings())
                .isEqualTo(toldAbove(
                        0.9,
                        black,
                        " of 4800 pixels are black: light becomes too faint away from the middle; a higher exposure shows"
                                + " more of it"));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.9, 0.99})
    void whitePixelsAreCounted(double speed) throws InterruptedException {
        RenderReport report = render(sky(speed, 3));
        long white = pixels(speed, light -> 8 * light > 1);
        assertThat(report.clipping().white()).isEqualTo(white).isPositive();
        assertThat(report.warnings())
                .isEqualTo(toldAbove(
                        0.5, white, " of 4800 pixels are brighter than white: a lower exposure shows more of them"));
    }

    private static List<String> toldAbove(double share, long pixels, String words) {
        return pixels > share * WIDTH * HEIGHT ? List.of(pixels + words) : List.of();
    }

    /** What the scene itself makes black or white is meant. */
    @Test
    void nothingIsToldWhereMotionLeavesColoursAlone() throws InterruptedException {
        RenderReport report = render(sky(0.999999, 3).withColours(ColourLaw.UNCHANGED));
        assertThat(report.clipping().white()).isZero();
        assertThat(report.warnings()).isEmpty();
    }

    private interface Light {
        boolean isClipped(double light);
    }

    private static long pixels(double speed, Light clipped) {
        double half = Math.tan(Math.toRadians(ThinLensCamera.DEFAULT.horizontalAngleDegrees()) / 2);
        long count = 0;
        for (int row = 0; row < HEIGHT; row++) {
            for (int column = 0; column < WIDTH; column++) {
                double x = (2 * column + 1 - WIDTH) * half / WIDTH;
                double y = (2 * row + 1 - HEIGHT) * half / WIDTH;
                double cosine = 1 / Math.sqrt(1 + x * x + y * y);
                double ofMiddle = (1 - speed) / (1 - speed * cosine);
                count += clipped.isClipped(SKY * Math.pow(ofMiddle, 4)) ? 1 : 0;
            }
        }
        return count;
    }

    private static Studio sky(double speed, double stops) {
        ThinLensCamera camera = Descriptions.with(ThinLensCamera.DEFAULT, "exposureStops", stops);
        return Descriptions.with(Studio.DEFAULT, "background", new UniformBackground(new Colour(SKY, SKY, SKY)))
                .withScene(List.of())
                .withCamera(camera)
                .withVelocity(Velocity.of(0, 0, speed))
                .withColours(ColourLaw.SEARCHLIGHT)
                .withSettings(new RenderSettings(WIDTH, HEIGHT, 1, 0, 1, 1000, ToneCurve.LINEAR));
    }

    private static RenderReport render(Studio studio) throws InterruptedException {
        try (Renderer renderer = new Renderer(2)) {
            return renderer.render(RenderPlan.of(studio)).report();
        }
    }
}
