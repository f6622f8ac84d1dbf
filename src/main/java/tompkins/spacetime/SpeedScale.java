package tompkins.spacetime;

import java.util.regex.Pattern;
import java.util.stream.Stream;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
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
    /** How far the speed is below that of light, 1 - beta, for speeds that a decimal fraction cannot hold. */
    @Meaning("How far the speed is below that of light, 1 - beta")
    ONE_MINUS_BETA("oneMinusBeta", "above 0 and at most 1");

    private static final int LONGEST_SHOWN = 40;

    private static final int DIGITS = 4;

    /** A number that differs from 1 by less needs more decimals to show four digits of the difference. */
    private static final double NEAR_ONE = 0.01;

    /** A number that differs from 1 by less is written as a sum. */
    private static final double VERY_NEAR_ONE = 1e-6;

    private static final int DIGITS_NEAR_ONE = 2;

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
     * What to add to the refusal of a velocity if one of its numbers was written as a number below 1 but has so many
     * nines that it was rounded to 1; empty otherwise.
     */
    public static String roundingHint(Stream<String> numbers) {
        return numbers.map(String::trim)
                .filter(number -> BELOW_ONE.matcher(number).matches() && Math.abs(Double.parseDouble(number)) == 1)
                .findFirst()
                .map(number -> "; " + OneLine.shortened(number, LONGEST_SHOWN)
                        + " was rounded to 1: to come nearer to the speed of light, write \"gamma\" or"
                        + " \"oneMinusBeta\" in the velocity of a scene file")
                .orElse("");
    }

    /**
     * A velocity's speed on this scale, for reading: four digits, more near 1, and very near 1 the difference:
     * {@code 10.48}, {@code 0.99954}, {@code 1 - 5e-9}, {@code 1 + 5e-7}.
     */
    public String reading(Velocity velocity) {
        return switch (this) {
            case BETA -> reading(velocity.speed(), -1, velocity.oneMinusSpeed());
            case GAMMA -> reading(velocity.gamma(), 1, velocity.gammaMinusOne());
            case RAPIDITY, ONE_MINUS_BETA -> rounded(valueOf(velocity), DIGITS);
        };
    }

    private static String reading(double value, int side, double distance) {
        if (distance == 0 || distance >= NEAR_ONE) {
            return rounded(value, DIGITS);
        }
        return distance < VERY_NEAR_ONE
                ? "1 " + (side < 0 ? "-" : "+") + " " + rounded(distance, DIGITS)
                : rounded(1 + side * NumberText.rounded(distance, DIGITS_NEAR_ONE), 12);
    }

    private static String rounded(double value, int digits) {
        return NumberText.of(NumberText.rounded(value, digits));
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
