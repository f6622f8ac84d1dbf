package tompkins.spacetime;

import java.util.regex.Pattern;
import java.util.stream.Stream;
import tompkins.property.Meaning;
import tompkins.property.OneLine;

/** The numbers by which a speed can be given. */
public enum SpeedScale {
    /** The speed itself, below 1. */
    @Meaning("The speed in units of c")
    BETA("beta", "at least 0 and below 1 (the speed of light)"),
    /** The Lorentz factor 1/sqrt(1 - beta^2), from 1. */
    @Meaning("The Lorentz factor 1/sqrt(1 - beta^2)")
    GAMMA("gamma", "1 or above"),
    /**
     * The rapidity artanh(beta), which adds up when velocities along one line are composed. 19.1 belongs to
     * {@link Velocity#LARGEST_GAMMA}.
     */
    @Meaning("The rapidity artanh(beta), which adds up when velocities along one line are composed")
    RAPIDITY("rapidity", "from 0 to 19.1"),
    /** What the speed lacks to that of light, 1 - beta, for speeds that a decimal fraction cannot hold. */
    @Meaning("How far the speed is below that of light, 1 - beta")
    ONE_MINUS_BETA("oneMinusBeta", "above 0 and at most 1");

    private static final int LONGEST_SHOWN = 40;

    private static final Pattern BELOW_ONE = Pattern.compile("[-+]?0*\\.[0-9]+");

    private final String key;
    private final String range;

    SpeedScale(String key, String range) {
        this.key = key;
        this.range = range;
    }

    /** The name in scene files. */
    public String key() {
        return key;
    }

    /** The allowed values, in words. */
    public String range() {
        return range;
    }

    /**
     * The end of the refusal of a velocity, if a number of it was written as one below 1 but has too many nines to be
     * told from it; empty if there is none.
     */
    public static String roundingHint(Stream<String> numbers) {
        return numbers.map(String::trim)
                .filter(number -> BELOW_ONE.matcher(number).matches() && Math.abs(Double.parseDouble(number)) == 1)
                .findFirst()
                .map(number -> "; " + OneLine.shortened(number, LONGEST_SHOWN)
                        + " was rounded to 1: nearer to the speed of light come \"gamma\" and"
                        + " \"oneMinusBeta\" in the velocity of a scene file")
                .orElse("");
    }

    /** The value of a velocity's speed on this scale. */
    public double valueOf(Velocity velocity) {
        return switch (this) {
            case BETA -> velocity.speed();
            case GAMMA -> velocity.gamma();
            case RAPIDITY -> velocity.rapidity();
            case ONE_MINUS_BETA -> velocity.oneMinusSpeed();
        };
    }
}
