package tompkins.spacetime;

import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tompkins.property.NumberText;

/** Speeds in kilometres or metres per second. */
public final class MetricSpeed {

    /** The speed of light in metres per second, by the definition of the metre. */
    private static final double LIGHT = 299_792_458;

    private static final Pattern WRITTEN = Pattern.compile("(.*?)(k?)m/s");

    private MetricSpeed() {}

    /**
     * The speed in units of c that a text such as {@code 150000 km/s} writes; empty if it does not end in one of the
     * two units.
     *
     * @throws NumberFormatException if no number stands before the unit
     */
    public static OptionalDouble parse(String text) {
        Matcher written = WRITTEN.matcher(text.strip());
        if (!written.matches()) {
            return OptionalDouble.empty();
        }
        double light = written.group(2).isEmpty() ? LIGHT : LIGHT / 1000;
        return OptionalDouble.of(NumberText.parse(written.group(1)) / light);
    }
}
