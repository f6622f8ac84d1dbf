package tompkins.ui;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.Font;
import java.util.Map;
import javax.swing.UIManager;

/** The looks of the window. */
enum Look {
    /** For rooms with daylight. */
    LIGHT(
            false,
            Map.of(
                    "Tompkins.canvas", 0xd9dce1,
                    "Tompkins.note", 0x5b6470,
                    "Tompkins.error", 0xb3261e,
                    "Tompkins.line", 0xaab2bd,
                    "Tompkins.sphereLight", 0xffffff,
                    "Tompkins.sphereDark", 0xd5dce6)),
    /** For dark rooms. */
    DARK(
            true,
            Map.of(
                    "Tompkins.canvas", 0x17191c,
                    "Tompkins.note", 0xa4acb8,
                    "Tompkins.error", 0xff8a80,
                    "Tompkins.line", 0x666d78,
                    "Tompkins.sphereLight", 0x59616d,
                    "Tompkins.sphereDark", 0x33383f)),
    /** For the back row: large type and high contrast. */
    PROJECTOR(
            false,
            Map.of(
                    "Tompkins.canvas", 0x000000,
                    "Tompkins.note", 0x000000,
                    "Tompkins.error", 0xa00000,
                    "Tompkins.line", 0x000000,
                    "Tompkins.sphereLight", 0xffffff,
                    "Tompkins.sphereDark", 0xdddddd));

    private static final float PROJECTOR_ENLARGES = 1.45f;

    private final boolean dark;
    private final Map<String, Integer> colours;

    Look(boolean dark, Map<String, Integer> colours) {
        this.dark = dark;
        this.colours = colours;
    }

    /** Gives all windows this look. */
    void install() {
        UIManager.put("defaultFont", null);
        FlatLaf.setGlobalExtraDefaults(
                this == PROJECTOR
                        ? Map.of(
                                "@background", "#fff",
                                "@foreground", "#000",
                                "@accentColor", "#0040c0",
                                "@disabledForeground", "#555",
                                "Component.borderColor", "#000",
                                "Component.focusWidth", "3",
                                "Button.borderColor", "#000")
                        : Map.of("@accentColor", dark ? "#4c9be8" : "#2468b8", "Component.focusWidth", "1"));
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
        if (this == PROJECTOR) {
            Font font = UIManager.getFont("defaultFont");
            UIManager.put("defaultFont", font.deriveFont(font.getSize2D() * PROJECTOR_ENLARGES));
            FlatLightLaf.setup();
        }
        colours.forEach((name, rgb) -> UIManager.put(name, new Color(rgb)));
        UIManager.put("[style].section", "font: bold; focusWidth: 0");
        FlatLaf.updateUI();
    }
}
