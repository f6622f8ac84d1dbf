package tompkins.ui.widget;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Font;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.Properties;
import java.util.function.Function;
import java.util.stream.Collectors;
import javax.swing.UIManager;

/** The looks of the window, whose colours are in resources. */
public enum Look {
    /** For rooms with daylight. */
    LIGHT(false, 1),
    /** For dark rooms. */
    DARK(true, 1),
    /** For the back row: large type, high contrast, and few controls beside a large picture. */
    PROJECTOR(false, 1.45f);

    /** The key of the look that all windows have; empty while there is none, or one with larger type. */
    private static final String INSTALLED = "Tompkins.look";

    private final boolean dark;
    private final float enlargement;

    Look(boolean dark, float enlargement) {
        this.dark = dark;
        this.enlargement = enlargement;
    }

    /** Gives all windows this look, if they do not have it yet. Called by the event thread. */
    public void install() {
        if (UIManager.get(INSTALLED) != this) {
            install(1);
            UIManager.put(INSTALLED, this);
        }
    }

    /** Gives all windows this look, with type that is larger by a factor. */
    public void install(float larger) {
        UIManager.put(INSTALLED, null);
        FlatLaf.setGlobalExtraDefaults(defaults());
        UIManager.put("defaultFont", null);
        setUp();
        float factor = larger * enlargement;
        if (factor != 1) {
            Font font = UIManager.getFont("defaultFont");
            UIManager.put("defaultFont", font.deriveFont(font.getSize2D() * factor));
            setUp();
        }
        // what is typed after Tab replaces the value
        UIManager.put("TextComponent.selectAllOnFocusPolicy", "always");
        FlatLaf.updateUI();
    }

    private void setUp() {
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
        PlainTextUI.install();
        LatinKeys.install();
        SqueezedText.guard();
    }

    /** What the look adds to its library, by the names that the library or this program gives it. */
    private Map<String, String> defaults() {
        Properties defaults = new Properties();
        try (InputStream resource = Look.class.getResourceAsStream("/tompkins/ui/Look-" + this + ".properties")) {
            defaults.load(resource);
        } catch (IOException missing) {
            throw new UncheckedIOException(missing);
        }
        return defaults.stringPropertyNames().stream()
                .collect(Collectors.toMap(Function.identity(), defaults::getProperty));
    }

    /** The type of what is written over a picture, which is larger on a projector. */
    public static Font captions() {
        Font font = UIManager.getFont("Tompkins.captionFont");
        return font == null ? UIManager.getFont("Label.font").deriveFont(Font.BOLD) : font;
    }

    /** A length on the screen that grows with the type of the look: a multiple of the size of the type, in pixels. */
    public static int pixels(double sizes) {
        return (int) Math.round(sizes * UIManager.getFont("defaultFont").getSize2D());
    }
}
