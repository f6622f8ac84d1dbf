package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** What is foretold comes true, within a factor of two. */
class CostForecastTest {

    /** A clock decides, and others use the machine too: the best of some attempts counts. */
    private static final int ATTEMPTS = 5;

    @ParameterizedTest
    @MethodSource("qualities")
    void foretellsSamplesAndTime(Quality quality) throws InterruptedException {
        Studio studio = PaperStudios.fig1b();
        RenderPlan plan = RenderPlan.of(studio.withSettings(studio.settings().withSize(320, 240)));
        double best = Double.POSITIVE_INFINITY;
        try (Renderer renderer = new Renderer(2)) {
            for (int attempt = 0; attempt < ATTEMPTS && best > 2; attempt++) {
                CostForecast forecast = CostForecast.of(plan, quality, renderer);
                RenderReport report = renderer.render(plan, quality).report();
                double samples = factor(forecast.samplesPerPixel() / report.samplesPerPixel());
                double time = factor(forecast.seconds() / (report.time().toNanos() / 1e9));
                best = Math.min(best, Math.max(samples, time));
            }
        }
        assertThat(best).isLessThanOrEqualTo(2);
    }

    /** How many times two numbers with this ratio differ. */
    private static double factor(double ratio) {
        return Math.max(ratio, 1 / ratio);
    }

    static Stream<Quality> qualities() {
        return Stream.of(new Quality.Samples(64), new Quality.TargetError(0.003), new Quality.TimeLimit(1));
    }
}
