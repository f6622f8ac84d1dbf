package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.image.LinearImage;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.trace.RenderPlan;

class PhotographTakerTest {

    private static final Progress NO_END = new Progress() {
        @Override
        public void setProgress(double share) {}

        @Override
        public boolean isCancelled() {
            return false;
        }
    };

    /** What is saved is as good as the scene says. */
    @ParameterizedTest
    @MethodSource
    void photographsHaveTheQualityThatIsWanted(RenderSettings settings) throws InterruptedException {
        Studio studio = Studios.lattice().withSettings(settings.withSize(40, 30));
        LinearImage taken;
        LinearImage again;
        try (PhotographTaker taker = new PhotographTaker()) {
            taken = taker.take(studio, NO_END, 0, 1).image();
            again = taker.take(studio, NO_END, 0, 1).image();
        }
        LinearImage rendered;
        try (Renderer renderer = new Renderer(1)) {
            rendered =
                    renderer.render(RenderPlan.of(studio), Quality.of(studio)).image();
        }

        assertThat(taken.rgb()).isEqualTo(rendered.rgb());
        assertThat(again.rgb()).isEqualTo(rendered.rgb());
    }

    static Stream<RenderSettings> photographsHaveTheQualityThatIsWanted() {
        RenderSettings settings = RenderSettings.DEFAULT;
        return Stream.of(settings, settings.withSamples(9), settings.withTargetError(0.02));
    }
}
