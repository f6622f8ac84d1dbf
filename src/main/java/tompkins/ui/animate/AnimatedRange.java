package tompkins.ui.animate;

import java.util.function.DoublePredicate;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.Studio;
import tompkins.ui.number.NumberProperty;
import tompkins.ui.number.SceneSize;
import tompkins.ui.widget.Range;

/**
 * The values between which a number runs.
 *
 * @param from the value at the beginning
 * @param to the value at the end, above or below the other
 */
record AnimatedRange(double from, double to) {

    /**
     * Values that show something: speeds from rest, times through the scene, other numbers from their value to twice
     * it, or to half of it if twice is too much.
     *
     * @param allowed whether the studio accepts a value
     */
    static AnimatedRange suggested(NumberProperty property, Studio studio, SceneSize size, DoublePredicate allowed) {
        Object last = property.number().path().last();
        if (last.equals(SpeedScale.BETA.key())) {
            return new AnimatedRange(0, 0.99);
        }
        if (last.equals(SpeedScale.RAPIDITY.key())) {
            return new AnimatedRange(0, 3);
        }
        if (property.equals(NumberProperty.openingTime())) {
            Range times = size.times(studio);
            return new AnimatedRange(times.minimum() / 2, times.maximum() / 2);
        }
        double now = property.number().in(studio);
        double twice = now == 0 ? 1 : 2 * now;
        return new AnimatedRange(now, allowed.test(twice) ? twice : now / 2);
    }
}
