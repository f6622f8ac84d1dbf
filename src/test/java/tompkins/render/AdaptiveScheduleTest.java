package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AdaptiveScheduleTest {

    private long now;

    /** However short the time: a picture that is not begun would be black. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theFirstPassIsNeverBrokenOff(boolean severalFirst) {
        AdaptiveSchedule schedule = schedule(severalFirst, 0.01);
        Film film = new Film(4, 4, 1, true);
        now = 1_000_000_000;

        Pass first = schedule.next(film, () -> false);

        assertThat(first).isNotNull();
        assertThat(first.share()).as("of all pixels").isEqualTo(1);
        assertThat(schedule.isOver()).as("while the first pass is taken").isFalse();
        schedule.next(film, () -> false);
        assertThat(schedule.isOver()).as("while the second pass is taken").isTrue();
    }

    @Test
    void laterPassesAreBrokenOffWhenTheTimeIsOver() {
        AdaptiveSchedule schedule = schedule(true, 10);
        Film film = new Film(4, 4, 1, true);
        schedule.next(film, () -> false);
        schedule.next(film, () -> false);

        now = 9_999_999_999L;
        assertThat(schedule.isOver()).isFalse();
        now = 10_000_000_000L;
        assertThat(schedule.isOver()).isTrue();
    }

    @Test
    void nothingIsPlannedWhenTheTimeIsOver() {
        AdaptiveSchedule schedule = schedule(false, 10);
        Film film = new Film(4, 4, 1, true);
        assertThat(schedule.next(film, () -> false)).isNotNull();
        now = 10_000_000_000L;

        assertThat(schedule.next(film, () -> false)).isNull();
    }

    @Test
    void progressIsTheShareOfTheTime() {
        AdaptiveSchedule schedule = schedule(false, 10);

        now = 2_500_000_000L;

        assertThat(schedule.progress(0)).isEqualTo(0.25);
        assertThat(schedule.wantedError()).isZero();
    }

    /** The border, and of the rest one pixel of 17 in each row, five columns on from row to row. */
    @Test
    void oneOfSeventeenIsLookedAtAfterTheCentres() {
        AdaptiveSchedule schedule = new AdaptiveSchedule(60 * 50, false, false, 0.01, endless());
        Film film = new Film(60, 50, 1, true);
        schedule.next(film, () -> false);
        fill(film, 1, 1);
        film.add(film.pixel(34, 0), 1, 1, 1, 1);

        Pass look = schedule.next(film, () -> false);

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
        film.add(0, 5, 5, 5, 1);
        assertThat(film.samples(0)).as("the first sample gives way").isEqualTo(1);
    }

    /** Left all is settled, right the halves differ: there the next samples go, and to the neighbours on the left. */
    @Test
    void roughPixelsGetTwiceAsManySamples() {
        AdaptiveSchedule schedule = new AdaptiveSchedule(20 * 10, true, false, 0.05, endless());
        Film film = new Film(20, 10, 1, true);
        schedule.next(film, () -> false);
        fill(film, 1, 8);
        for (int pixel = 0; pixel < 200; pixel++) {
            double light = pixel % 20 >= 12 ? 16 : 8;
            film.add(pixel, light, light, light, 8);
        }

        Pass next = schedule.next(film, () -> false);

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

    @Test
    void nothingIsTakenWhenTheErrorIsReached() {
        AdaptiveSchedule schedule = new AdaptiveSchedule(16, true, false, 0.05, endless());
        Film film = new Film(4, 4, 1, true);
        assertThat(schedule.next(film, () -> false).samples()).isEqualTo(16);
        fill(film, 1, 8);
        fill(film, 1.01, 8);

        assertThat(schedule.next(film, () -> false)).isNull();
    }

    @Test
    void whoIsStoppedPlansNoMore() {
        AdaptiveSchedule schedule = new AdaptiveSchedule(16, false, false, 0.05, endless());
        Film film = new Film(4, 4, 1, true);
        schedule.next(film, () -> false);
        fill(film, 1, 1);

        assertThatThrownBy(() -> schedule.next(film, () -> true)).isInstanceOf(CancellationException.class);
    }

    @Test
    void fixedSamplesAreWhatWasAskedFor() {
        FixedSchedule schedule = new FixedSchedule(Pass.of(4, 4, false));
        Film film = new Film(4, 4, 1, false);

        int samples = 0;
        for (Pass pass = schedule.next(film, () -> false); pass != null; pass = schedule.next(film, () -> false)) {
            samples += pass.samples();
        }

        assertThat(samples).isEqualTo(4);
        assertThat(schedule.progress(1)).isEqualTo(0.25);
        assertThat(schedule.wantedError()).isZero();
        assertThat(schedule.isOver()).isFalse();
    }

    @Test
    void timeIsCountedFromTheStart() {
        now = 5_000_000_000L;
        TimeBudget time = new TimeBudget(10, () -> now);
        now = 8_000_000_000L;

        assertThat(time.spent()).isEqualTo(3);
        assertThat(time.left()).isEqualTo(7);
        assertThat(time.isLimited()).isTrue();
        assertThat(endless().isLimited()).isFalse();
        assertThat(endless().isOver()).isFalse();
    }

    private TimeBudget endless() {
        return new TimeBudget(Double.POSITIVE_INFINITY, () -> now);
    }

    private static void fill(Film film, double light, int samples) {
        for (int pixel = 0; pixel < film.width() * film.height(); pixel++) {
            film.add(pixel, light * samples, light * samples, light * samples, samples);
        }
    }

    private AdaptiveSchedule schedule(boolean severalFirst, double seconds) {
        return new AdaptiveSchedule(16, severalFirst, false, 0, new TimeBudget(seconds, () -> now));
    }
}
