package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** In all of these pictures each pixel has 16 samples, and in some of them one sample has met a light of 1. */
class IsolatedHighlightsTest {

    private static final int SIDE = 64;
    private static final int SAMPLES = 16;

    /** Of 16 samples of which one is 1 and the others 0. */
    private static final double VARIANCE = 1.0 / 16;

    @Test
    void aLightInOnePixelIsASpeck() {
        IsolatedHighlights specks = specks(film(place(20, 30)));
        assertThat(specks.found()).containsExactly(place(20, 30));
        assertThat(specks.isEmpty()).isFalse();
    }

    @Test
    void aLightOnTheCornerOfFourPixelsIsASpeck() {
        IsolatedHighlights specks = specks(film(place(20, 30), place(21, 30), place(20, 31), place(21, 31)));
        assertThat(specks.found()).contains(place(20, 30), place(21, 31));
    }

    /** Neither in the middle nor at the ends. */
    @ParameterizedTest
    @CsvSource({"1, 0", "0, 1", "1, 1", "1, -1"})
    void aThinLineIsNone(int across, int down) {
        int[] line = IntStream.range(0, 20)
                .map(i -> place(20 + across * i, 30 + down * i))
                .toArray();
        assertThat(specks(film(line)).isEmpty()).isTrue();
    }

    /** Beyond it the picture may go on with the same. */
    @Test
    void atTheBorderNothingStandsAlone() {
        assertThat(specks(film(place(0, 30), place(20, SIDE - 1))).isEmpty()).isTrue();
    }

    /** Half of a pixel is bright: its mean shows that. */
    @Test
    void whatTheMeanShowsIsNone() {
        Film film = film();
        int pixel = place(20, 30);
        film.add(pixel, SAMPLES, SAMPLES, SAMPLES, 3 * SAMPLES, SAMPLES);
        assertThat(film.sampleVariance(pixel)).isGreaterThan(0.2);
        assertThat(specks(film).isEmpty()).isTrue();
    }

    /** One sample in each pixel, 16 in one: its neighbours may show more of the same, or not. */
    @Test
    void neighboursWithOneSampleAreNamed() {
        Film film = new Film(SIDE, SIDE, 1, true);
        IntStream.range(0, SIDE * SIDE).forEach(pixel -> add(film, pixel, 1, 0));
        film.restart(place(20, 30));
        meet(film, place(20, 30));
        IsolatedHighlights specks = specks(film);
        assertThat(specks.isEmpty()).isTrue();
        assertThat(specks.untested().stream())
                .hasSize(8)
                .doesNotContain(place(20, 30))
                .allMatch(pixel -> Math.abs(pixel % SIDE - 20) <= 1 && Math.abs(pixel / SIDE - 30) <= 1);
        assertThat(specks(film(place(20, 30))).untested().isEmpty()).isTrue();
    }

    /**
     * The lights cover 1/16 of their pixels, as far as 16 samples can tell: half of the variance of 16 independent
     * samples is left where samples are spread evenly and one of them is expected to meet such a light.
     */
    @Test
    void lightIsExpectedWhereItMayHaveBeenMissed() {
        int[] places = IntStream.range(0, 64)
                .map(i -> place(4 + 8 * (i % 8), 4 + 8 * (i / 8)))
                .toArray();
        Film film = film(places);
        PixelVariance variance = new PixelVariance(film, () -> false);
        variance.expect(new IsolatedHighlights(film, variance, () -> false));

        double perPixel = 64 * VARIANCE / (SIDE * SIDE);
        assertThat(Math.pow(variance.rootMeanSquare(), 2)).isCloseTo(perPixel / 16 / 2, withinPercentage(20));
        assertThat(variance.variance(place(0, 0))).isCloseTo(perPixel / 16 / 2, withinPercentage(20));
        assertThat(variance.variance(place(4, 4)))
                .as("as likely elsewhere as where it was found")
                .isCloseTo(perPixel / 16 / 2, withinPercentage(20));
    }

    private static IsolatedHighlights specks(Film film) {
        return new IsolatedHighlights(film, new PixelVariance(film, () -> false), () -> false);
    }

    private static int place(int column, int row) {
        return row * SIDE + column;
    }

    private static Film film(int... lit) {
        Film film = new Film(SIDE, SIDE, 1, true);
        for (int pixel : lit) {
            meet(film, pixel);
        }
        for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
            if (film.samples(pixel) == 0) {
                add(film, pixel, SAMPLES, 0);
            }
        }
        return film;
    }

    /** One of the first half of the samples of a pixel meets the light. */
    private static void meet(Film film, int pixel) {
        add(film, pixel, 1, 1);
        add(film, pixel, SAMPLES / 2 - 1, 0);
        add(film, pixel, SAMPLES / 2, 0);
    }

    private static void add(Film film, int pixel, int samples, double light) {
        Films.add(film, pixel, samples * light, samples * light, samples * light, samples);
    }
}
