package tompkins.measure;

import java.util.Locale;

/**
 * A measured number.
 *
 * @param key what it is, in one word with inner capitals
 * @param unit its unit; empty if it has none
 * @param value the number; NaN if there is none
 * @param uncertainty by how much it is uncertain because a place in a picture is known to half a pixel, or NaN if that
 *     is not known or means nothing
 */
public record Quantity(String key, String unit, double value, double uncertainty) {

    /** A number without an uncertainty. */
    public static Quantity exact(String key, String unit, double value) {
        return new Quantity(key, unit, value, Double.NaN);
    }

    /** Its key in words. */
    public String words() {
        return key.replaceAll("([A-Z])", " $1").toLowerCase(Locale.ROOT);
    }
}
