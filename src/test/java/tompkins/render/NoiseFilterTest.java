package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.image.PictureDifference;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

class NoiseFilterTest {

    /** Against a picture of many samples with another seed. */
    @Test
    void fewSamplesOfABlurLookLikeMany() throws InterruptedException {
        Studio figure = PaperStudios.fig3a();
        Studio small = figure.withSettings(figure.settings().withSize(320, 240));
        try (Renderer renderer = new Renderer()) {
            Studio otherSeed = small.withSettings(small.settings().withSeed(7));
            LinearImage many = renderer.render(RenderPlan.of(otherSeed), new Quality.Samples(128))
                    .image();
            RenderJob four = renderer.render(RenderPlan.of(small), new Quality.Samples(4));
            double unfiltered = PictureDifference.ofLight(four.image(), many);
            Quality good = new Quality.TargetError(0.01);
            assertThat(PictureDifference.ofLight(four.preview(good), many)).isLessThan(unfiltered / 2);
            assertThat(four.preview(new Quality.Samples(8)).rgb())
                    .as("no noisier in the end than before")
                    .isEqualTo(four.image().rgb());
            RenderJob sixteen = renderer.render(RenderPlan.of(small), new Quality.Samples(16));
            assertThat(sixteen.preview(new Quality.Samples(16)).rgb())
                    .as("complete")
                    .isEqualTo(sixteen.image().rgb());
            assertThat(PictureDifference.ofLight(sixteen.preview(good), many))
                    .isLessThan(0.7 * PictureDifference.ofLight(sixteen.image(), many));
        }
    }

    /** One sample of each pixel, and of every second one in both directions. */
    @Test
    void singleSamplesOfABlurAreFiltered() throws InterruptedException {
        Studio figure = PaperStudios.fig3a();
        RenderPlan plan = RenderPlan.of(figure.withSettings(figure.settings().withSize(320, 240)));
        try (Renderer renderer = new Renderer()) {
            LinearImage many = renderer.render(plan, new Quality.Samples(128)).image();
            List<Double> gains = new ArrayList<>();
            Quality aim = new Quality.Samples(16);
            RenderListener looks = RenderListener.afterEachPass(job -> gains.add(
                    PictureDifference.ofLight(job.preview(aim), many) / PictureDifference.ofLight(job.image(), many)));
            renderer.startCoarse(plan, aim, looks).await();
            assertThat(gains.get(2)).as("every second pixel").isLessThan(0.7);
            assertThat(gains.get(3)).as("one sample").isLessThan(0.4);
            assertThat(gains.get(gains.size() - 1)).as("complete").isEqualTo(1);
        }
    }

    /** A sharp edge and a bright pixel, without variance. */
    @Test
    void whatIsNoNoiseStays() {
        Film film = new Film(40, 30, 1, true);
        for (int pixel = 0; pixel < film.pixels(); pixel++) {
            double light = pixel == 500 ? 0.5 : pixel % 40 < 17 ? 0.2 : 0.8;
            film.add(pixel, light, light, light, 1);
            film.add(pixel, light, light, light, 1);
        }
        LinearImage filtered = NoiseFilter.image(film);
        LinearImage image = film.image();
        for (int i = 0; i < image.rgb().length; i++) {
            assertThat(filtered.rgb()[i]).isCloseTo(image.rgb()[i], within(1e-3f));
        }
    }

    /** The searchlight effect can be so strong; sums of such variances are infinite in single precision. */
    @Test
    void lightBeyondAllMeasureStaysANumber() {
        Film film = new Film(10, 10, 1, true);
        for (int pixel = 0; pixel < film.pixels(); pixel++) {
            film.add(pixel, pixel % 2 == 0 ? 1.5e19 : 0, 0, 0, 1);
            film.add(pixel, pixel % 2 == 0 ? 0 : 1.5e19, 0, 0, 1);
        }
        LinearImage filtered = NoiseFilter.image(film);
        for (int i = 0; i < filtered.rgb().length; i += 3) {
            assertThat(filtered.rgb()[i]).isCloseTo(0.75e19f, within(1e13f));
        }
    }
}
