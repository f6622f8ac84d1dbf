package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AdaptiveScheduleTest {

    private long now;

    /** However short the time: a picture that is not begun would be black. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theFirstPassIsNeverBrokenOff(boolean severalFirst) {
        Film film = new Film(4, 4, 1, true);
        AdaptiveSchedule schedule = schedule(film, severalFirst, 0.01);
        now = 1_000_000_000;

        Pass first = schedule.next(() -> false);

        assertThat(first).isNotNull();
        assertThat(first.stride()).as("coarse, so that it soon ends").isEqualTo(8);
        assertThat(schedule.isOver()).as("while the first pass is taken").isFalse();
        schedule.next(() -> false);
        assertThat(schedule.isOver()).as("while the second pass is taken").isTrue();
    }

    @Test
    void laterPassesAreBrokenOffWhenTheTimeIsOver() {
        Film film = new Film(4, 4, 1, true);
        AdaptiveSchedule schedule = schedule(film, true, 10);
        schedule.next(() -> false);
        schedule.next(() -> false);

        now = 9_999_999_999L;
        assertThat(schedule.isOver()).isFalse();
        now = 10_000_000_000L;
        assertThat(schedule.isOver()).isTrue();
    }

    @Test
    void progressIsTheShareOfTheTime() {
        now = 5_000_000_000L;
        AdaptiveSchedule schedule = schedule(new Film(4, 4, 1, true), false, 10);
        now = 7_500_000_000L;
        assertThat(schedule.progress(0)).isEqualTo(0.25);
    }

    /** The border, and of the rest one pixel of 17 in each row, five columns on from row to row. */
    @Test
    void oneOfSeventeenIsLookedAtAfterTheCentres() {
        Film film = new Film(60, 50, 1, true);
        AdaptiveSchedule schedule = new AdaptiveSchedule(film, false, false, 0.01, endless());
        takeFirstPasses(schedule);
        fill(film, pixel -> 1, 1);
        Films.add(film, film.pixel(34, 0), 1, 1, 1, 1);

        Pass look = schedule.next(() -> false);

        int looked = 0;
        for (int row = 0; row < 50; row++) {
            for (int column = 0; column < 60; column++) {
                boolean isBorder = row == 0 || row == 49 || column == 0 || column == 59;
                boolean isOfSeventeen = Math.floorMod(column - 12 * row, 17) == 0;
                boolean isExpected = (isBorder || isOfSeventeen) && !(column == 34 && row == 0);
                assertThat(look.takes(column, row, film.pixel(column, row))).isEqualTo(isExpected);
                looked += isExpected ? 1 : 0;
            }
        }
        assertThat(look.firstSample()).isZero();
        assertThat(look.samples()).isEqualTo(16);
        assertThat(look.work()).isCloseTo(16.0 * looked / 3000, within(1e-12));
        Films.add(film, 0, 5, 5, 5, 1);
        assertThat(film.samples(0)).as("the first sample gives way").isEqualTo(1);
    }

    /** A benchmark compares what it costs to begin with fewer. */
    @Test
    void fewerFirstSamplesCanBeTaken() {
        Film film = new Film(60, 50, 1, true);
        AdaptiveSchedule everywhere = new AdaptiveSchedule(film, 4, true, false, 0.01, endless());
        AdaptiveSchedule after = new AdaptiveSchedule(film, 4, false, false, 0.01, endless());
        takeFirstPasses(after);
        fill(film, pixel -> 1, 1);

        assertThat(everywhere.next(() -> false).samples()).isEqualTo(4);
        assertThat(after.next(() -> false).samples()).isEqualTo(4);
    }

    /** Left all is settled, right the halves differ: there the next samples go, and to the neighbours on the left. */
    @Test
    void roughPixelsGetTwiceAsManySamples() {
        Film film = new Film(20, 10, 1, true);
        AdaptiveSchedule schedule = new AdaptiveSchedule(film, true, false, 0.05, endless());
        takeFirstPasses(schedule);
        fill(film, pixel -> 1, 8);
        fill(film, pixel -> pixel % 20 >= 12 ? 2 : 1, 8);

        Pass next = schedule.next(() -> false);

        assertThat(next.firstSample()).isEqualTo(16);
        assertThat(next.samples()).isEqualTo(16);
        for (int pixel = 0; pixel < 200; pixel++) {
            boolean isRough = pixel % 20 >= 12;
            boolean isNextToRough = pixel % 20 == 11;
            if (!isNextToRough) {
                assertThat(next.takes(pixel % 20, pixel / 20, pixel))
                        .as("pixel %d", pixel)
                        .isEqualTo(isRough);
            }
        }
        assertThat(schedule.wantedError()).isEqualTo(0.05);
        assertThat(schedule.progress(0)).isZero();
        assertThat(schedule.progress(16)).isBetween(0.1, 1.0);
    }

    /**
     * The halves differ more from column to column. The samples of a pixel are doubled at least, which leaves 2^-1.25
     * of its variance: so many pixels are chosen that the sum is just below the square of 0.9 of the error.
     */
    @Test
    void noMoreAreDoubledThanTheErrorNeeds() {
        Film film = new Film(100, 20, 1, true);
        AdaptiveSchedule schedule = new AdaptiveSchedule(film, true, false, 0.053, endless());
        takeFirstPasses(schedule);
        fill(film, pixel -> 1, 8);
        fill(film, pixel -> 1 + 0.0025 * (pixel % 100), 8);
        PixelVariance variances = new PixelVariance(film, () -> false);

        Pass next = schedule.next(() -> false);
        double left = 0;
        for (int pixel = 0; pixel < 2000; pixel++) {
            left += variances.variance(pixel) * (next.takes(0, 0, pixel) ? Math.pow(2, -1.25) : 1);
        }
        assertThat(Math.sqrt(left / 2000)).isBetween(0.88 * 0.053, 0.9 * 0.053);
    }

    /** A pixel of each tile, and all others. */
    private static void takeFirstPasses(AdaptiveSchedule schedule) {
        Pass first = schedule.next(() -> false);
        Pass others = schedule.next(() -> false);
        assertThat(first.fraction() + others.fraction()).isEqualTo(1);
        assertThat(others.samples()).isEqualTo(first.samples());
    }

    private TimeBudget endless() {
        return new TimeBudget(Double.POSITIVE_INFINITY, () -> now);
    }

    /** Adds samples to all pixels; the light of each depends on the pixel. */
    private static void fill(Film film, IntToDoubleFunction light, int samples) {
        for (int pixel = 0; pixel < film.pixels(); pixel++) {
            double sum = samples * light.applyAsDouble(pixel);
            Films.add(film, pixel, sum, sum, sum, samples);
        }
    }

    private AdaptiveSchedule schedule(Film film, boolean severalFirst, double seconds) {
        return new AdaptiveSchedule(film, severalFirst, true, 0, new TimeBudget(seconds, () -> now));
    }
}
