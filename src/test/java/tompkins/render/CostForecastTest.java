package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.TestRun;
import tompkins.io.BundledScenes;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/**
 * What is foretold comes true, within a factor of two. Samples are compared, not seconds: other programs run here too.
 */
class CostForecastTest {

    private static final Renderer RENDERER = new Renderer(2);

    /** Foretells from the first blocks alone, so that nothing depends on the speed of the machine. */
    private static final double NO_PATIENCE = 0;

    private static final String[] QUICK = {
        "fig2b",
        "flash-train",
        "lesson-10-rod-in-the-barn",
        "long-exposure",
        "rolling-fence",
        "stereo-panorama",
        "surface-ideal-lens",
        "terrell-cube"
    };

    @AfterAll
    static void close() {
        RENDERER.close();
    }

    @ParameterizedTest
    @MethodSource("someScenes")
    void foretellsTheSamplesOfAWantedError(Studio scene) throws InterruptedException {
        RenderPlan plan = plan(scene, TestRun.cases(128, 320), TestRun.cases(96, 240));
        Quality quality = new Quality.TargetError(0.01);

        double foretold = CostForecast.of(plan, quality, RENDERER, NO_PATIENCE)
                .orElseThrow()
                .samplesPerPixel();

        double taken = RENDERER.render(plan, quality).report().samplesPerPixel();
        assertThat(foretold / taken).isBetween(0.5, 2.0);
    }

    @ParameterizedTest
    @MethodSource("someScenes")
    void knowsTheSamplesOfAFixedNumber(Studio scene) throws InterruptedException {
        RenderPlan plan = plan(scene, 50, 30);

        CostForecast forecast =
                CostForecast.of(plan, new Quality.Samples(5), RENDERER).orElseThrow();

        assertThat(forecast.samplesPerPixel()).isEqualTo(5);
        assertThat(forecast.seconds()).isPositive();
    }

    /** A cold part at 1000 samples in a second, half done, and a warm one at 4000; 0.5 s of planning. */
    @Test
    void whatIsLeftGoesAtTheGreatestSpeed() {
        ForecastSamples costs = new ForecastSamples();
        costs.add(10, 500, 0.5, 1, 0.5);
        costs.add(30, 6000, 1, 2, 0.5);

        assertThat(costs.rate()).isEqualTo(4000);
        assertThat(costs.samplesPerPixel()).isEqualTo(175, within(1e-9));
        assertThat(costs.seconds(400 * 175)).isEqualTo(0.5 + 2 + 63_500.0 / 4000, within(1e-9));
    }

    /**
     * One of a part's 2560 samples took 4 s; a tenth of the next part's 1000 took 1 s; another part got none in 2 s.
     */
    @Test
    void partsThatWereStoppedTellWhatTheyTook() {
        ForecastSamples costs = new ForecastSamples();
        costs.add(2560, 0, 0, 2, 0);
        assertThat(costs.isEmpty()).isTrue();

        costs.add(2560, 1, 1.0 / 2560, 4, 0);
        costs.add(100, 100, 0.1, 1, 0);
        assertThat(costs.isEmpty()).isFalse();
        assertThat(costs.rate()).isEqualTo(100);
        assertThat(costs.samplesPerPixel()).isEqualTo(3560.0 / 2660, within(1e-9));
        assertThat(costs.seconds(1101)).isEqualTo(2 + 4 + 1 + 10, within(1e-9));
    }

    private static RenderPlan plan(Studio studio, int width, int height) {
        return RenderPlan.of(studio.withSettings(studio.settings().withSize(width, height)));
    }

    /** Usually some of different kinds, whose first blocks take a fraction of a second. */
    static Stream<Named<Studio>> someScenes() {
        return BundledScenes.named(TestRun.THOROUGH ? new String[0] : QUICK).entrySet().stream()
                .map(scene -> Named.of(scene.getKey(), scene.getValue()));
    }
}
