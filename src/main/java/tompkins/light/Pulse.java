package tompkins.light;

import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
import tompkins.property.Require;

/**
 * A lamp that is on for a while, once or again and again: at the own time tau it shines where 0 &lt;= tau - start &lt;
 * duration, up to whole periods. The beginning belongs to the flash, the end does not.
 */
@Meaning("The lamp shines for a while, once or again and again; it is as bright then as a lamp that is always on")
public record Pulse(
        @Meaning(
                value = "Time of the lamp's own frame at which a flash begins, -1e50 to 1e50; that time is 0 when the"
                        + " origin of the frame passes its place, and for a lamp at rest it is that of the scene",
                unit = "time")
        double start,

        @Meaning(value = "How long the lamp shines, in its own time, above 0 and at most 1e50", unit = "time")
        double duration,

        @Meaning(
                value = "Proper time between flashes, before and after, at least the duration; 0 for one flash",
                unit = "time")
        double period)
        implements Flash {

    /** One flash of length 1 at time 0. */
    public static final Pulse DEFAULT = new Pulse(0, 1, 0);

    /** Checks all values. */
    public Pulse {
        Require.coordinate("start", start);
        if (duration == 0) {
            throw new InvalidPropertyException(
                    "duration", "above 0; for a flash of an instant choose a short one", duration);
        }
        Require.distance("duration", duration);
        Require.duration("period", period);
        if (period > 0 && period < duration) {
            throw new InvalidPropertyException(
                    "period", "0, or at least the duration of the flash (" + NumberText.of(duration) + ")", period);
        }
    }

    @Override
    public boolean isLit(double ownTime) {
        double phase = phase(ownTime);
        return phase >= 0 && phase < duration || period > 0 && period == duration;
    }

    /** Own time since the last flash began; negative before the first, if there is a first. */
    public double phase(double ownTime) {
        return ownTime - start - cycle(ownTime) * period;
    }

    /** The number of the flash that began last, counted from 0 at the start; 0 if there is only one. */
    public double cycle(double ownTime) {
        return period > 0 ? Math.floor((ownTime - start) / period) : 0;
    }
}
