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

    @ParameterizedTest
    @MethodSource("qualities")
    void foretellsSamplesAndTime(Quality quality) throws InterruptedException {
        Studio studio = PaperStudios.fig1b();
        RenderPlan plan = RenderPlan.of(studio.withSettings(studio.settings().withSize(320, 240)));
        try (Renderer renderer = new Renderer(2)) {
            CostForecast forecast = CostForecast.of(plan, quality, renderer);
            RenderReport report = renderer.render(plan, quality).report();
            assertThat(forecast.samplesPerPixel() / report.samplesPerPixel()).isBetween(0.5, 2.0);
            // the clock of a busy machine: a little more than the factor of two that holds on an idle one
            assertThat(forecast.seconds() / (report.time().toNanos() / 1e9)).isBetween(0.3, 3.0);
        }
    }

    static Stream<Quality> qualities() {
        return Stream.of(new Quality.Samples(64), new Quality.TargetError(0.003), new Quality.TimeLimit(1));
    }
}
