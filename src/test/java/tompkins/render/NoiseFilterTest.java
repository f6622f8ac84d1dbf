package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
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
        Studio small = figure.withSettings(figure.settings().withSize(240, 180));
        RenderPlan plan = RenderPlan.of(small);
        Quality good = new Quality.TargetError(0.01);
        Quality sixteen = new Quality.Samples(16);
        try (Renderer renderer = new Renderer()) {
            Studio otherSeed = small.withSettings(small.settings().withSeed(7));
            LinearImage many = renderer.render(RenderPlan.of(otherSeed), new Quality.Samples(128))
                    .image();
            RenderJob four = renderer.render(plan, new Quality.Samples(4));
            assertThat(gain(four, good, many)).isLessThan(0.5);
            assertThat(four.preview(new Quality.Samples(8)).rgb())
                    .as("no noisier in the end than before")
                    .isEqualTo(four.image().rgb());
            List<Double> gains = new ArrayList<>();
            RenderListener looks = Looks.afterEachPass(job -> gains.add(gain(job, sixteen, many)));
            RenderJob coarse = renderer.startCoarse(plan, sixteen, looks);
            coarse.await();
            assertThat(gains.get(2)).as("every second pixel").isLessThan(0.7);
            assertThat(gains.get(3)).as("one sample").isLessThan(0.4);
            assertThat(gains.get(gains.size() - 1)).as("complete").isEqualTo(1);
            assertThat(gain(coarse, good, many)).as("sixteen samples").isLessThan(0.7);
        }
    }

    /** The error of a filtered picture divided by that of the picture. */
    private static double gain(RenderJob job, Quality aim, LinearImage many) {
        return PictureDifference.ofLight(job.preview(aim), many) / PictureDifference.ofLight(job.image(), many);
    }

    /** Two random samples of each pixel of some bands, against the formula, pixel by pixel, away from the edges. */
    @Test
    void isTheMeanOfTheFormula() {
        Film film = new Film(24, 40, 1, true);
        Random random = new Random(3);
        double[][] light = new double[film.pixels()][3];
        double[] variances = new double[film.pixels()];
        double[] samples = new double[6];
        for (int pixel = 0; pixel < film.pixels(); pixel++) {
            for (int channel = 0; channel < 3; channel++) {
                double first = random.nextDouble();
                double second = first + 0.2 * random.nextDouble();
                light[pixel][channel] = (first + second) / 2;
                variances[pixel] += (first - second) * (first - second) / 2 / 3 / Math.pow(2, PixelVariance.POWER);
                samples[channel] = first;
                samples[3 + channel] = second;
            }
            Films.add(film, pixel, samples[0], samples[1], samples[2], 1);
            Films.add(film, pixel, samples[3], samples[4], samples[5], 1);
        }
        LinearImage filtered = NoiseFilter.image(film);
        for (int row = 6; row < 34; row++) {
            for (int column = 6; column < 18; column++) {
                double[] sums = new double[4];
                for (int other : square(film.pixel(column, row), 2)) {
                    double weight = weight(film.pixel(column, row), other, light, variances);
                    for (int channel = 0; channel < 3; channel++) {
                        sums[channel] += weight * light[other][channel];
                    }
                    sums[3] += weight;
                }
                for (int channel = 0; channel < 3; channel++) {
                    assertThat((double) filtered.value(column, row, channel))
                            .isCloseTo(sums[channel] / sums[3], within(1e-5));
                }
            }
        }
    }

    private static double weight(int first, int second, double[][] light, double[] variances) {
        int offset = second - first;
        if (offset == 0) {
            return 1;
        }
        double squares = 0;
        for (int pixel : square(first, 1)) {
            for (int channel = 0; channel < 3; channel++) {
                squares += Math.pow(light[pixel][channel] - light[pixel + offset][channel], 2);
            }
        }
        double chance = 0;
        for (int pixel : square(first, 3)) {
            chance += 3 * 9 * (variances[pixel] + variances[pixel + offset]) / 49;
        }
        double known = chance + 3e-4;
        return Math.pow(known / (known + Math.max(0, squares - chance) / 4), 4);
    }

    /** The pixels around one of a film of 24 columns. */
    private static int[] square(int pixel, int reach) {
        return IntStream.rangeClosed(-reach, reach)
                .flatMap(row -> IntStream.rangeClosed(-reach, reach).map(column -> pixel + 24 * row + column))
                .toArray();
    }

    /** A sharp edge and a bright pixel, without variance. */
    @Test
    void whatIsNoNoiseStays() {
        Film film = new Film(40, 30, 1, true);
        for (int pixel = 0; pixel < film.pixels(); pixel++) {
            double light = pixel == 500 ? 0.5 : pixel % 40 < 17 ? 0.2 : 0.8;
            Films.add(film, pixel, light, light, light, 1);
            Films.add(film, pixel, light, light, light, 1);
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
            Films.add(film, pixel, pixel % 2 == 0 ? 1.5e19 : 0, 0, 0, 1);
            Films.add(film, pixel, pixel % 2 == 0 ? 0 : 1.5e19, 0, 0, 1);
        }
        LinearImage filtered = NoiseFilter.image(film);
        for (int i = 0; i < filtered.rgb().length; i += 3) {
            assertThat(filtered.rgb()[i]).isCloseTo(0.75e19f, within(1e13f));
        }
    }
}
