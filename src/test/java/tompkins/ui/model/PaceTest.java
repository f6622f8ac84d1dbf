package tompkins.ui.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PaceTest {

    /** With 2 ms from one to the next, in which the next is planned. */
    @Test
    void aRideHasThirtyPicturesInASecond() {
        assertThat(30 * (Pace.RIDE.glimpseSeconds() + 0.002)).isBetween(0.95, 1.0);
        assertThat(Pace.ANSWER.glimpseSeconds()).isEqualTo(Pace.RIDE.glimpseSeconds());
    }
}
