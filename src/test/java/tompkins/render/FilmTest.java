package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.image.LinearImage;
import tompkins.ray.Colour;

class FilmTest {

    @Test
    void aPixelIsTheMeanOfItsSamplesTimesTheExposure() {
        Film film = new Film(3, 2, 4, true);
        add(film, 1, 1, new Colour(0.25, 0.5, 1));
        add(film, 1, 1, new Colour(0.75, 0, 3));

        LinearImage image = film.image();

        assertThat(image.value(1, 1, 0)).isEqualTo(2f);
        assertThat(image.value(1, 1, 1)).isEqualTo(1f);
        assertThat(image.value(1, 1, 2)).isEqualTo(8f);
    }

    /** A million samples of 10^30: floats end at 3.4 x 10^38. */
    @Test
    void mostOfTheBrightestSamplesHaveAFiniteMean() {
        Film film = new Film(1, 1, 1, true);
        Colour bright = Colour.grey(1e30);
        assertThat(bright.isFinite()).isTrue();
        for (int sample = 0; sample < 1 << 20; sample++) {
            add(film, 0, 0, bright);
        }
        assertThat(film.image().value(0, 0, 0)).isCloseTo(1e30f, withinPercentage(1));
    }

    /** The brightest light that a scene may have, and as many stops as a camera may have. */
    @Test
    void exposureDoesNotMakeLightInfinite() {
        Film film = new Film(1, 1, Math.scalb(1.0, 100), true);
        add(film, 0, 0, Colour.grey(Math.scalb(1.0, 104)));
        assertThat(film.image().value(0, 0, 0)).isEqualTo(Float.MAX_VALUE);
    }

    @Test
    void aPixelWithoutSampleIsInterpolatedBetweenCoarseOnes() {
        Film film = new Film(12, 12, 1, false);
        add(film, 0, 0, Colour.grey(1));
        add(film, 8, 0, Colour.grey(2));
        add(film, 0, 8, Colour.grey(4));
        add(film, 8, 8, Colour.grey(9));
        add(film, 4, 4, Colour.grey(7));

        LinearImage image = film.image();

        assertThat(image.value(4, 0, 0)).isEqualTo(1.5f);
        assertThat(image.value(0, 2, 0)).isEqualTo(1.75f);
        assertThat(image.value(2, 2, 0)).as("its four neighbours").isEqualTo((1 + 1.5f + 2.5f + 7) / 4);
        assertThat(image.value(4, 2, 0)).as("beside a finer sample").isEqualTo(4.25f);
        assertThat(image.value(4, 4, 0)).as("a sample of its own").isEqualTo(7f);
        assertThat(image.value(11, 0, 0)).as("at the edge of what is there").isEqualTo(2f);
    }

    @Test
    void aRestartedPixelKeepsItsSampleUntilTheNextOne() {
        Film film = new Film(1, 1, 1, false);
        add(film, 0, 0, Colour.grey(1));
        film.restart(0);
        assertThat(film.image().value(0, 0, 0)).isEqualTo(1f);
        add(film, 0, 0, Colour.grey(3));
        add(film, 0, 0, Colour.grey(5));
        assertThat(film.image().value(0, 0, 0)).isEqualTo(4f);
        assertThat(film.samples(0)).isEqualTo(2);
    }

    /**
     * Means of 1 and of 4 from a and b samples: the variance of the mean of all, after the formula that the variance of
     * D = 1 - 4 is sigma^2 (1/a + 1/b), is 9/(1/a + 1/b)/(a + b).
     */
    @ParameterizedTest
    @CsvSource({"1, 1", "2, 1", "2, 2", "4, 1", "4, 2", "4, 3", "4, 4", "8, 3"})
    void halvesOfAnySizesTellTheVariance(int first, int second) {
        Film film = new Film(1, 1, 2, true);
        for (int sample = 0; sample < first + second; sample++) {
            add(film, 0, 0, Colour.grey(sample < first ? 1 : 4));
        }

        double variance = 9 / (1.0 / first + 1.0 / second) / (first + second);
        assertThat(film.halvesVariance(0)).as("exposed by a factor 2").isCloseTo(4 * variance, withinPercentage(1e-9));
    }

    /**
     * Grey samples of 0, 0.1, ... 0.7 have a variance of 0.06 (n^2 - 1 over 12, times n over n - 1), exposed twice 4.
     */
    @Test
    void varianceOfSamplesIsThatOfTheirValues() {
        Film film = new Film(1, 1, 2, true);
        Films.add(film, 0, 9, 9, 9, 1);
        film.restart(0);
        for (int sample = 0; sample < 8; sample++) {
            Films.add(film, 0, sample / 10.0, sample / 10.0, sample / 10.0, 1);
        }
        assertThat(film.sampleVariance(0)).isEqualTo(4 * 0.06, within(1e-6));

        Film summed = new Film(1, 1, 2, true);
        summed.add(0, 2.8, 2.8, 2.8, 3 * 1.4, 8);
        assertThat(summed.sampleVariance(0)).as("from their sums").isEqualTo(4 * 0.06, within(1e-6));
    }

    /** A sum in single precision is not exact. */
    @Test
    void equalSamplesHaveNoVariance() {
        Film film = new Film(1, 1, 1, true);
        for (int sample = 0; sample < 1000; sample++) {
            Films.add(film, 0, 0.7, 0.1, 0.3, 1);
        }
        assertThat(film.sampleVariance(0)).isZero();
    }

    private static void add(Film film, int column, int row, Colour colour) {
        Films.add(film, film.pixel(column, row), colour.red(), colour.green(), colour.blue(), 1);
    }
}
