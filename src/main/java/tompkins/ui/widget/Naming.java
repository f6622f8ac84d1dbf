package tompkins.ui.widget;

import javax.accessibility.AccessibleContext;
import javax.swing.JComponent;

/** Says what a component is called and what it means: to the mouse, to screen readers and to tests. */
public final class Naming {

    private Naming() {}

    /** Gives a component a name and a tooltip, which may be empty. */
    public static void name(JComponent component, String name, String tip) {
        component.setName(name);
        component.setToolTipText(tip.isEmpty() ? null : Tips.html(tip));
        AccessibleContext accessible = component.getAccessibleContext();
        accessible.setAccessibleName(name);
        accessible.setAccessibleDescription(tip);
    }
}
