package tompkins.ui.widget;

import java.awt.Component;
import java.util.function.Function;
import javax.accessibility.AccessibleContext;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComponent;
import javax.swing.JList;

/** Says what a component is called and what it means: to the mouse, to screen readers and to tests. */
public final class Naming {

    private Naming() {}

    /** Gives a component a name and a tooltip, which may be empty. */
    public static void name(JComponent component, String name, String tip) {
        component.setName(name);
        component.setToolTipText(tip.isEmpty() ? null : Tips.wrapped(tip));
        AccessibleContext accessible = component.getAccessibleContext();
        accessible.setAccessibleName(name);
        accessible.setAccessibleDescription(tip);
    }

    /** Shows the objects of a combo box by their names. */
    public static DefaultListCellRenderer renderer(Function<Object, String> name) {
        return PlainText.in(new DefaultListCellRenderer() {
            @Override
            public Component getListCellRendererComponent(
                    JList<?> list, Object value, int index, boolean selected, boolean focused) {
                return super.getListCellRendererComponent(
                        list, value == null ? "" : name.apply(value), index, selected, focused);
            }
        });
    }
}
