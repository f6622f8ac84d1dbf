package tompkins.ui.widget;

import static java.util.Map.entry;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.Font;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.swing.UIManager;

/** The looks of the window. */
public enum Look {
    /** For rooms with daylight. */
    LIGHT(
            false,
            1,
            "#2468b8",
            "#868c95",
            Map.ofEntries(
                    entry("Tompkins.chosen", 0xffffff),
                    entry("Tompkins.hover", 0xe2e5ea),
                    entry("Tompkins.canvas", 0xd9dce1),
                    entry("Tompkins.note", 0x5b6470),
                    entry("Tompkins.error", 0xb3261e),
                    entry("Tompkins.line", 0xaab2bd),
                    entry("Tompkins.found", 0xffe9a0),
                    entry("Tompkins.foundHere", 0xffb74d),
                    entry("Tompkins.sphereLight", 0xffffff),
                    entry("Tompkins.sphereDark", 0xd5dce6))),
    /** For dark rooms. */
    DARK(
            true,
            1,
            "#4c9be8",
            "#8f959c",
            Map.ofEntries(
                    entry("Tompkins.chosen", 0x000000),
                    entry("Tompkins.hover", 0x4a4f56),
                    entry("Tompkins.canvas", 0x17191c),
                    entry("Tompkins.note", 0xa4acb8),
                    entry("Tompkins.error", 0xff8a80),
                    entry("Tompkins.line", 0x666d78),
                    entry("Tompkins.found", 0x54471a),
                    entry("Tompkins.foundHere", 0x805400),
                    entry("Tompkins.sphereLight", 0x59616d),
                    entry("Tompkins.sphereDark", 0x33383f))),
    /** For the back row: large type and high contrast. */
    PROJECTOR(
            false,
            1.45f,
            "#0040c0",
            "#000",
            Map.ofEntries(
                    entry("Tompkins.chosen", 0xffffff),
                    entry("Tompkins.hover", 0xdde4f5),
                    entry("Tompkins.canvas", 0x000000),
                    entry("Tompkins.note", 0x000000),
                    entry("Tompkins.error", 0xa00000),
                    entry("Tompkins.line", 0x000000),
                    entry("Tompkins.found", 0xffe680),
                    entry("Tompkins.foundHere", 0xffb030),
                    entry("Tompkins.sphereLight", 0xffffff),
                    entry("Tompkins.sphereDark", 0xdddddd)));

    /** The key of the look that all windows have; empty while there is none, or one with larger type. */
    private static final String INSTALLED = "Tompkins.look";

    /** Only the documents have links; a colour for those of all windows would take 50 ms of each start. */
    private static final String NO_LINKS = "null";

    /** Colours that show where there is something to use: at least 3 times as light or dark as their background. */
    private static final List<String> EDGES = List.of(
            "Component.borderColor",
            "Button.borderColor",
            "CheckBox.icon.borderColor",
            "Slider.trackColor",
            "ScrollBar.thumb");

    private final boolean dark;
    private final float enlargement;
    private final String accent;
    private final String edge;
    private final Map<String, Integer> colours;

    Look(boolean dark, float enlargement, String accent, String edge, Map<String, Integer> colours) {
        this.dark = dark;
        this.enlargement = enlargement;
        this.accent = accent;
        this.edge = edge;
        this.colours = colours;
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
        colours.forEach((name, rgb) -> UIManager.put(name, new Color(rgb)));
        UIManager.put("Tompkins.link", UIManager.getColor("Component.accentColor"));
        FlatLaf.updateUI();
    }

    private void setUp() {
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
        PlainTextUI.install();
        SqueezedText.guard();
    }

    private Map<String, String> defaults() {
        Map<String, String> defaults = new HashMap<>(
                Map.of("@accentColor", accent, "Component.focusWidth", "1", "Component.linkColor", NO_LINKS));
        // so thin that a fainter colour could hardly be seen
        defaults.put("ComboBox.buttonArrowColor", "@foreground");
        for (String part : EDGES) {
            defaults.put(part, edge);
        }
        if (this == PROJECTOR) {
            defaults.putAll(Map.of(
                    "@background", "#fff",
                    "@foreground", "#000",
                    "@disabledForeground", "#555",
                    "Component.focusWidth", "3"));
        }
        return defaults;
    }

    /** A length on the screen that grows with the type of the look: a multiple of the size of the type, in pixels. */
    public static int pixels(double sizes) {
        return (int) Math.round(sizes * UIManager.getFont("defaultFont").getSize2D());
    }
}
