package tompkins.ui.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.Studio;
import tompkins.studio.Studios;

class AnimationTest {

    private static Animation speed(Animation.Course course) {
        return new Animation(NumberProperty.speed(SpeedScale.BETA), 0, 0.8, 0.4, course);
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
        Animation animation = new Animation(
                NumberProperty.speed(SpeedScale.BETA), 0.1234567890123, last, 1, Animation.Course.FORWARDS);
        assertThat(animation.value(0)).isEqualTo(0.1234567890123);
        assertThat(animation.value(1)).isEqualTo(last);
        assertThat(animation.value(1 - 1e-12)).isEqualTo(last);
        assertThat(animation.studio(Studio.DEFAULT, 1).velocity().value()).isEqualTo(last);
    }

    @Test
    void filesHaveAllFramesAndLoopsDoNotRepeatTheFirst() {
        assertThat(speed(Animation.Course.FORWARDS).frames()).isEqualTo(10);
        assertThat(speed(Animation.Course.FORWARDS).timeOf(9)).isEqualTo(1);
        assertThat(speed(Animation.Course.THERE_AND_BACK).timeOf(9)).isEqualTo(0.9);
    }

    @Test
    void everyNumberOfTheSceneCanRun() {
        List<NumberProperty> properties = NumberProperty.of(Studios.sphere());
        NumberProperty radius = properties.stream()
                .filter(property -> property.name().equals("Scene \u203a sphere \u203a Radius"))
                .findFirst()
                .orElseThrow();
        Studio larger = radius.with().apply(Studios.sphere(), 2.0);
        assertThat(((Sphere) larger.scene().get(0)).radius()).isEqualTo(2);
        for (NumberProperty property : properties) {
            double value = property.get().applyAsDouble(Studios.sphere());
            Studio same = property.with().apply(Studios.sphere(), value);
            assertThat(property.get().applyAsDouble(same)).as(property.name()).isEqualTo(value);
        }
    }
}
