package tompkins.ui.widget;

import java.math.BigInteger;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;

/** How the numbers of a property are read, shown and changed by keys: numbers with fractions, or whole numbers. */
public enum NumberKind {

    /** Numbers with fractions: a step changes the last of three digits. */
    DOUBLE {
        @Override
        Number parse(String property, String text) {
            return Numbers.parse(property, text);
        }

        @Override
        String text(Number number, boolean typed) {
            double value = number.doubleValue();
            double shown = NumberText.rounded(value, SHOWN_DIGITS);
            return Double.isFinite(value) && (typed || shown == value) ? Numbers.text(shown) : Numbers.brief(value);
        }

        @Override
        String stepped(Number number, int steps) {
            double value = number.doubleValue();
            double size = value == 0 ? 1 : Math.pow(10, Math.floor(Math.log10(Math.abs(value))));
            return Numbers.text(NumberText.rounded(value + steps * size * STEP, STEPPED_DIGITS));
        }
    },

    /** Whole numbers of the range of an {@code int}. */
    INT {
        @Override
        Number parse(String property, String text) {
            return (int) Numbers.parseWhole(property, text, Integer.MIN_VALUE, Integer.MAX_VALUE);
        }
    },

    /** Whole numbers of the range of a {@code long}. */
    LONG {
        @Override
        Number parse(String property, String text) {
            return Numbers.parseWhole(property, text, Long.MIN_VALUE, Long.MAX_VALUE);
        }
    };

    private static final double STEP = 0.01;
    private static final int SHOWN_DIGITS = 7;
    private static final int STEPPED_DIGITS = 6;

    /**
     * The number that a text writes.
     *
     * @throws InvalidPropertyException if it is not a number of this kind
     */
    abstract Number parse(String property, String text);

    /**
     * What a field shows of a number: as many digits as there is room for if it was typed or is short enough to have
     * been, otherwise only the first digits. Whole numbers have all their digits.
     */
    String text(Number number, boolean typed) {
        return Long.toString(number.longValue());
    }

    /** The number after some steps, up or down; a step between whole numbers is 1. */
    String stepped(Number number, int steps) {
        // beyond the range, so that it is refused as if it had been typed
        return BigInteger.valueOf(number.longValue())
                .add(BigInteger.valueOf(steps))
                .toString();
    }
}
