package tompkins.measure;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;
import tompkins.property.NumberText;

/**
 * A measured number.
 *
 * @param key what it is, in one word with inner capitals
 * @param unit its unit; empty if it has none
 * @param value the number; NaN if there is none
 * @param uncertainty by how much half a pixel in the picture changes it; NaN if that is not known or means nothing
 */
public record Quantity(String key, String unit, double value, double uncertainty) {

    /** A number without an uncertainty. */
    public static Quantity exact(String key, String unit, double value) {
        return new Quantity(key, unit, value, Double.NaN);
    }

    /**
     * The number rounded to the second digit of its uncertainty; to the given digits if the uncertainty is not known or
     * 0.
     */
    public double rounded(int digits) {
        if (!Double.isFinite(value) || !Double.isFinite(uncertainty) || uncertainty == 0) {
            return NumberText.rounded(value, digits);
        }
        int places = 1 - (int) Math.floor(Math.log10(uncertainty));
        return new BigDecimal(value).setScale(places, RoundingMode.HALF_EVEN).doubleValue() + 0.0;
    }

    /** Its key in words. */
    public String words() {
        return key.replaceAll("([A-Z])", " $1").toLowerCase(Locale.ROOT);
    }
}
