package tompkins.ui.widget;

import java.text.MessageFormat;
import java.util.Arrays;
import java.util.Locale;
import java.util.MissingResourceException;
import java.util.ResourceBundle;

/** All texts of the window, from one resource bundle. */
public final class Texts {

    private static final String BUNDLE = "tompkins.ui.Labels";

    private Texts() {}

    /** The text for a key. */
    public static String get(String key) {
        return bundle().getString(key);
    }

    /** The text for a key, with values in its places {0}, {1}, ... */
    public static String get(String key, Object... values) {
        // as texts, because numbers would get separators between thousands
        Object[] texts = Arrays.stream(values).map(String::valueOf).toArray();
        return new MessageFormat(get(key), Locale.ROOT).format(texts);
    }

    /** The text for a key, or another one if the bundle has none. */
    static String getOr(String key, String other) {
        try {
            return bundle().getString(key);
        } catch (MissingResourceException none) {
            return other;
        }
    }

    private static ResourceBundle bundle() {
        return ResourceBundle.getBundle(BUNDLE, Locale.getDefault(Locale.Category.DISPLAY));
    }
}
