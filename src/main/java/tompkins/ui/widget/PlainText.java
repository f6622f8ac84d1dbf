package tompkins.ui.widget;

import javax.swing.JComponent;

/**
 * Text that is shown as it stands. Swing takes what begins like HTML for HTML, and loads the pictures that it names;
 * but names and titles come from scenes, and scenes from anybody.
 */
public final class PlainText {

    private PlainText() {}

    /** Makes a component, which has no text yet, show all text as it stands; returns it. */
    public static <C extends JComponent> C in(C component) {
        component.putClientProperty("html.disable", true);
        return component;
    }
}
