package tompkins.ui.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PaceTest {

    private static final long MILLISECOND = 1_000_000;

    @Test
    void aHandSeesSomethingSoonAndThenAFrameLong() {
        assertThat(Pace.HAND.waits(1 / 64.0, 29 * MILLISECOND)).isTrue();
        assertThat(Pace.HAND.waits(1 / 64.0, 31 * MILLISECOND)).isFalse();
        assertThat(Pace.HAND.waits(1, 29 * MILLISECOND)).isTrue();
        assertThat(Pace.HAND.frame()).isEqualTo(30 * MILLISECOND);
    }

    @Test
    void aFilmWaitsForASampleInEachPixelThatComesInTime() {
        assertThat(Pace.FILM.waits(1 / 64.0, 79 * MILLISECOND)).isTrue();
        assertThat(Pace.FILM.waits(1 / 64.0, 81 * MILLISECOND)).isFalse();
        assertThat(Pace.FILM.waits(1, 40 * MILLISECOND)).isFalse();
        assertThat(Pace.FILM.frame()).isEqualTo(0);
    }

    /** With 2 ms from one to the next, in which the next is planned. */
    @Test
    void aRideHasThirtyPicturesInASecond() {
        assertThat(30 * (Pace.RIDE.glimpseSeconds() + 0.002)).isBetween(0.95, 1.0);
        assertThat(Pace.ANSWER.glimpseSeconds()).isEqualTo(Pace.RIDE.glimpseSeconds());
    }
}
