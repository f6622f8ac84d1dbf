package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** Two surfaces in turn, half a period each, by the proper time of the object: on a plane they show simultaneity. */
@Meaning("Two surfaces in turn, by the proper time of the object; each point by its own time")
public record Blinking(
        @Meaning(value = "Time after which the first surface returns", unit = "time")
        double period,

        @Meaning("Surface in the first half of each period, which begins at time 0")
        Surface first,

        @Meaning("Surface in the second half") Surface second)
        implements CompositeSurface {

    /** White and dark grey. */
    public static final Blinking DEFAULT = new Blinking(
            1, new ColouredSurface(Colour.WHITE, Colour.BLACK), new ColouredSurface(Colour.grey(0.2), Colour.BLACK));

    /** Checks all values. */
    public Blinking {
        Require.positive("period", period);
    }

    @Override
    public double fractionOfSecond(Ray ray, Hit hit) {
        return SquareWave.isOdd(Math.floor(2 * hit.clockReading() / period)) ? 1 : 0;
    }

    @Override
    public boolean showsTime() {
        return true;
    }
}
