package tompkins.ui;

import java.util.Collections;
import java.util.Enumeration;
import java.util.Locale;
import java.util.ResourceBundle;

/** The texts of a language whose words are half as long again as English ones, to see whether they find room. */
public final class Labels_en_XA extends ResourceBundle {

    private static final ResourceBundle ENGLISH = ResourceBundle.getBundle("tompkins.ui.Labels", Locale.ROOT);

    @Override
    protected Object handleGetObject(String key) {
        if (!ENGLISH.containsKey(key)) {
            return null;
        }
        String text = ENGLISH.getString(key);
        return text + "~".repeat(text.length() / 2);
    }

    @Override
    public Enumeration<String> getKeys() {
        return Collections.enumeration(ENGLISH.keySet());
    }
}
