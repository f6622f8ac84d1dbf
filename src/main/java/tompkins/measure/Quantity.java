package tompkins.measure;

import java.math.BigDecimal;
import java.math.RoundingMode;
import tompkins.property.NumberText;

/**
 * A number that is told.
 *
 * @param key what it is, in one word with inner capitals or in words with underscores; empty if it is told to people
 *     alone
 * @param name what people call it; empty if it is told to programs alone
 * @param unit its unit; empty if it has none
 * @param value the number; NaN if there is none
 * @param uncertainty by how much half a pixel in the picture changes it; NaN if that is not known or means nothing
 */
public record Quantity(String key, String name, String unit, double value, double uncertainty) implements Fact {

    private static final int MOST_DECIMALS = 9;

    /** A number without an uncertainty. */
    public static Quantity exact(String key, String name, String unit, double value) {
        return new Quantity(key, name, unit, value, Double.NaN);
    }

    /** Whether it is known how uncertain the number is, and that is not exact. */
    public boolean isUncertain() {
        return Double.isFinite(uncertainty) && uncertainty > 0;
    }

    /** The number as text, to the second digit of its uncertainty, or with the given digits if that is not known. */
    public String text(int digits) {
        return isUncertain() ? decimals(value) : NumberText.of(NumberText.rounded(value, digits));
    }

    /** The number as text, to the second digit of its uncertainty, but without zeros at the end. */
    public String briefText() {
        return NumberText.of(isUncertain() ? Double.parseDouble(decimals(value)) : value);
    }

    /** The first two digits of its uncertainty. */
    public String uncertaintyText() {
        return decimals(uncertainty);
    }

    /** A number to the second digit of the uncertainty; zeros at the end are digits that are known. */
    private String decimals(double number) {
        int decimals = 1 - (int) Math.floor(Math.log10(uncertainty));
        BigDecimal rounded = new BigDecimal(number).setScale(decimals, RoundingMode.HALF_EVEN);
        return decimals > 0 && decimals <= MOST_DECIMALS
                ? rounded.toPlainString()
                : NumberText.of(rounded.doubleValue() + 0.0);
    }
}
