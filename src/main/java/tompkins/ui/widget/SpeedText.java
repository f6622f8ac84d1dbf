package tompkins.ui.widget;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.joml.Vector3dc;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.spacetime.MetricSpeed;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

/** Speeds as people write them: {@code 0.97}, {@code 97%}, {@code gamma 10}, {@code 1-1e-9}, {@code rapidity 2}. */
public final class SpeedText {

    private static final Pattern NAMED = Pattern.compile("([a-z\\u0370-\\u03ff]+)\\s*=?\\s*(.*)");
    private static final Pattern BELOW_ONE = Pattern.compile("1(?:\\.0*)?\\s*-\\s*(.*)");
    private static final Pattern ABOVE_ONE = Pattern.compile("1(?:\\.0*)?\\s*\\+\\s*(.*)");

    private static final Map<String, SpeedScale> NAMES = Map.ofEntries(
            Map.entry("beta", SpeedScale.BETA),
            Map.entry("\u03b2", SpeedScale.BETA),
            Map.entry("v", SpeedScale.BETA),
            Map.entry("gamma", SpeedScale.GAMMA),
            Map.entry("\u03b3", SpeedScale.GAMMA),
            Map.entry("rapidity", SpeedScale.RAPIDITY),
            Map.entry("eta", SpeedScale.RAPIDITY),
            Map.entry("\u03b7", SpeedScale.RAPIDITY),
            Map.entry("oneminusbeta", SpeedScale.ONE_MINUS_BETA));

    /** The characters of a speed that fit into its field, and are steady enough in an animation. */
    private static final int CHARACTERS = 9;

    /** Digits of the components of a velocity. */
    private static final int VECTOR_DIGITS = 4;

    private SpeedText() {}

    /**
     * The speed of a velocity on a scale, as short as a field: {@code 0.97}, {@code 1-1e-9}, {@code 1+5e-7}. As it was
     * given, if it was given on that scale; otherwise the first digits.
     */
    public static String of(Velocity velocity, SpeedScale scale) {
        if (scale == SpeedScale.BETA && velocity.speed() > 0.999999) {
            return "1-" + Numbers.fitting(velocity.oneMinusSpeed(), CHARACTERS - 2);
        }
        String given = Numbers.fitting(scale.valueOf(velocity), CHARACTERS);
        boolean vanishes = scale == SpeedScale.GAMMA && given.equals("1") && !velocity.isRest();
        return velocity.scale() == scale && !vanishes
                ? given
                : scale.reading(velocity).replace(" ", "");
    }

    /**
     * A velocity in units of c: its components or, near the speed of light, where their few digits would show no
     * difference from it, speed times direction.
     */
    public static String vector(Velocity velocity) {
        if (NumberText.rounded(velocity.speed(), VECTOR_DIGITS) < 1) {
            return Numbers.brief(velocity.components());
        }
        String speed = of(velocity, SpeedScale.BETA);
        return (speed.contains("-") ? "(" + speed + ")" : speed) + " \u00b7 " + Numbers.brief(velocity.direction());
    }

    /**
     * The velocity of the speed that a text writes.
     *
     * @param scale the scale of a number without a name
     * @throws InvalidPropertyException if the text is not a speed, or the speed is out of range
     */
    public static Velocity parse(String text, SpeedScale scale, Vector3dc direction) {
        String plain = text.strip()
                .toLowerCase(Locale.ROOT)
                .replace('\u2212', '-')
                .replaceAll("(?<=[0-9.%])\\s*c$", "")
                .replaceAll("^(?=[-+.,0-9].*(%|/s)$)", "beta ")
                .replaceAll("^1\\s*-\\s*(beta|\u03b2)\\s*=?\\s*", "oneminusbeta ");
        Matcher belowOne = BELOW_ONE.matcher(plain);
        if (belowOne.matches()) {
            return Velocity.of(SpeedScale.ONE_MINUS_BETA, number(belowOne.group(1), text), direction);
        }
        Matcher named = NAMED.matcher(plain);
        if (!named.matches()) {
            return onScale(scale, plain, text, direction);
        }
        SpeedScale other = NAMES.get(named.group(1));
        if (other == null) {
            throw wrong(text);
        }
        return onScale(other, named.group(2), text, direction);
    }

    private static Velocity onScale(SpeedScale scale, String digits, String text, Vector3dc direction) {
        Matcher aboveOne = ABOVE_ONE.matcher(digits);
        if (scale == SpeedScale.GAMMA && aboveOne.matches()) {
            return ofGammaMinusOne(number(aboveOne.group(1), text), direction);
        }
        return Velocity.of(scale, number(digits, text), direction);
    }

    /** Uses the rapidity, because gamma would lose digits. */
    private static Velocity ofGammaMinusOne(double value, Vector3dc direction) {
        if (!(value >= 0)) {
            // which refuses it
            return Velocity.of(SpeedScale.GAMMA, 1 + value, direction);
        }
        // exp(eta) = gamma + sqrt(gamma^2 - 1)
        return Velocity.of(SpeedScale.RAPIDITY, Math.log1p(value + Math.sqrt(value * (value + 2))), direction);
    }

    private static double number(String digits, String text) {
        try {
            OptionalDouble metric = MetricSpeed.parse(digits);
            if (metric.isPresent()) {
                return metric.getAsDouble();
            }
            return digits.endsWith("%")
                    ? new BigDecimal(NumberText.withPoint(
                                    digits.substring(0, digits.length() - 1).strip()))
                            .movePointLeft(2)
                            .doubleValue()
                    : NumberText.parse(digits);
        } catch (ArithmeticException | NumberFormatException e) {
            throw wrong(text);
        }
    }

    private static InvalidPropertyException wrong(String text) {
        return Numbers.noNumber("speed", "written like 0.97, 97 %, 150000 km/s, gamma 10, rapidity 2 or 1-1e-9", text);
    }
}
