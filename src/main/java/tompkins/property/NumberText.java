package tompkins.property;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.regex.Pattern;

/**
 * Numbers as people write them, for messages, fields, command lines and scene files: {@code 2}, {@code 0.000001},
 * {@code 1e-9}.
 */
public final class NumberText {

    private static final int FEWEST_DIGITS = 2;

    /** No two decimal numbers of so many digits are read as the same bits, if these are not denormalized. */
    private static final int UNIQUE_DIGITS = 15;

    private static final double SMALLEST_PLAIN = 1e-6;
    private static final double LARGEST_PLAIN = 1e9;

    private static final Pattern NUMBER =
            Pattern.compile("[+-]?([0-9]++\\.?[0-9]*+|\\.[0-9]++)([eE][+-]?[0-9]++)?|NaN|[+-]?Infinity");

    private static final Pattern DECIMAL_COMMA = Pattern.compile("[+-]?[0-9]*,[0-9]+([eE][+-]?[0-9]+)?");

    private static final Pattern THOUSANDS_COMMA = Pattern.compile("[+-]?[1-9][0-9]{0,2},[0-9]{3}([eE].*)?");

    private NumberText() {}

    /**
     * The number that a text writes, with spaces around it or without, and with a point or a comma before its fraction,
     * see {@link #withPoint}. Other forms that Java accepts, such as {@code 3d} or {@code 0x1p3}, are refused.
     *
     * @throws NumberFormatException if the text is not a number
     */
    public static double parse(String text) {
        String plain = withPoint(text.trim());
        if (!NUMBER.matcher(plain).matches()) {
            throw new NumberFormatException(text);
        }
        return Double.parseDouble(plain);
    }

    /** What is allowed where {@link #vanishes} refuses a number. */
    public static final String NOT_VANISHING = "0 or a number that is not smaller than " + of(Double.MIN_VALUE);

    /** Whether the text of a number other than 0 is read as 0: it is too small. */
    public static boolean vanishes(String text) {
        return text.matches("[^eE]*[1-9].*") && parse(text) == 0;
    }

    /**
     * The text of a number with a decimal comma, such as {@code 0,9}, with a point instead. Any other text stays as it
     * is, even {@code 1,500}, in which the comma may also separate thousands.
     */
    public static String withPoint(String text) {
        boolean decimal = DECIMAL_COMMA.matcher(text).matches()
                && !THOUSANDS_COMMA.matcher(text).matches();
        return decimal ? text.replace(',', '.') : text;
    }

    /** As many digits of a number as it needs, and no more: read again, they give the same bits. */
    public static String of(double value) {
        String written = Double.toString(value);
        if (written.length() <= UNIQUE_DIGITS && written.indexOf('E') < 0) {
            return written.endsWith(".0") ? written.substring(0, written.length() - 2) : written;
        }
        double size = Math.abs(value);
        BigDecimal shortest = shortest(value);
        if (size >= SMALLEST_PLAIN && size < LARGEST_PLAIN) {
            return shortest.toPlainString();
        }
        int exponent = shortest.precision() - shortest.scale() - 1;
        return shortest.movePointLeft(exponent).toPlainString() + "e" + exponent;
    }

    /**
     * The nearest decimal number with the fewest digits, two or more, that is read as the same bits.
     * {@link Double#toString} of Java 17 gives some numbers more digits than they need, such as 2e23.
     */
    private static BigDecimal shortest(double value) {
        BigDecimal written = new BigDecimal(Double.toString(value)).stripTrailingZeros();
        if (written.precision() <= UNIQUE_DIGITS && Math.abs(value) >= Double.MIN_NORMAL) {
            return written;
        }
        BigDecimal exact = new BigDecimal(value);
        int digits = Math.max(FEWEST_DIGITS, written.precision());
        BigDecimal shortest = nearest(exact, digits);
        while (digits > FEWEST_DIGITS && nearest(exact, digits - 1).doubleValue() == value) {
            shortest = nearest(exact, --digits);
        }
        return shortest.stripTrailingZeros();
    }

    private static BigDecimal nearest(BigDecimal exact, int digits) {
        return exact.round(new MathContext(digits, RoundingMode.HALF_EVEN));
    }

    /** The number with at most the given digits, never negative zero; a number that is not finite stays as it is. */
    public static double rounded(double value, int digits) {
        return Double.isFinite(value)
                ? new BigDecimal(value).round(new MathContext(digits)).doubleValue() + 0.0
                : value;
    }

    /** The sum of two finite numbers as they are written: 0.1 and 0.2 give 0.3. */
    public static double sum(double first, double second) {
        return new BigDecimal(of(first)).add(new BigDecimal(of(second))).doubleValue();
    }

    /** The first digits of a finite number, without a power of ten. */
    public static String plain(double value, int digits) {
        double rounded = rounded(value, digits);
        return rounded == 0 ? "0" : shortest(rounded).toPlainString();
    }
}
