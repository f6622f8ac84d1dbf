package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;

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

    private AdaptiveSchedule schedule(boolean severalFirst, double seconds) {
        return new AdaptiveSchedule(16, severalFirst, false, 0, new TimeBudget(seconds, () -> now));
    }
}
