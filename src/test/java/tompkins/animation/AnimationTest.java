package tompkins.animation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;

class AnimationTest {

    private static Animation speed(Animation.Course course) {
        return new Animation(StudioNumber.speed(SpeedScale.BETA), 0, 0.8, 0.4, course);
    }

    @Test
    void coursesRunForwardsBackAndThereAndBack() {
        assertThat(speed(Animation.Course.FORWARDS).value(0.25)).isCloseTo(0.2, within(1e-12));
        assertThat(speed(Animation.Course.BACKWARDS).value(0.25)).isCloseTo(0.6, within(1e-12));
        assertThat(speed(Animation.Course.THERE_AND_BACK).value(0.25)).isCloseTo(0.4, within(1e-12));
        assertThat(speed(Animation.Course.THERE_AND_BACK).value(0.5)).isEqualTo(0.8);
    }

    /** The next number with nine digits above the last speed is that of light. */
    @Test
    void nothingLiesBeyondTheEndsAndTheyAreReached() {
        double last = 0.9999999999;
        Animation animation =
                new Animation(StudioNumber.speed(SpeedScale.BETA), 0.1234567890123, last, 1, Animation.Course.FORWARDS);
        assertThat(animation.value(0)).isEqualTo(0.1234567890123);
        assertThat(animation.value(1)).isEqualTo(last);
        assertThat(animation.value(1 - 1e-12)).isEqualTo(last);
        assertThat(animation.studio(Studio.DEFAULT, 1).velocity().value()).isEqualTo(last);
    }

    /** A quarter of the way from 1e12 - 5 to 1e12 + 5; a twentieth from 0.9999999999 to 0.99999999995. */
    @Test
    void endsThatHaveManyDigitsInCommonAreFarEnoughApart() {
        Animation far = new Animation(StudioNumber.OPENING_TIME, 1e12 - 5, 1e12 + 5, 1, Animation.Course.FORWARDS);
        assertThat(far.value(0.25)).isEqualTo(999999999997.5);
        Animation fast = new Animation(
                StudioNumber.speed(SpeedScale.BETA), 0.9999999999, 0.99999999995, 1, Animation.Course.FORWARDS);
        assertThat(fast.value(0.05)).isEqualTo(0.9999999999025);
        Animation still = new Animation(StudioNumber.OPENING_TIME, 1.25, 1.25, 1, Animation.Course.FORWARDS);
        assertThat(still.value(0.5)).isEqualTo(1.25);
    }

    @Test
    void filesHaveAllFramesAndLoopsDoNotRepeatTheFirst() {
        assertThat(speed(Animation.Course.FORWARDS).frames()).isEqualTo(10);
        assertThat(speed(Animation.Course.FORWARDS).timeOf(9)).isEqualTo(1);
        assertThat(speed(Animation.Course.THERE_AND_BACK).timeOf(9)).isEqualTo(0.9);
    }
}
