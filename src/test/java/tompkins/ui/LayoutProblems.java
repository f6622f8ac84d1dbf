package tompkins.ui;

import java.awt.Component;
import java.awt.Container;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.JViewport;
import javax.swing.text.JTextComponent;
import tompkins.ui.widget.ShortLabel;

/** What is wrong with a layout: components outside their parents, and texts that are cut. */
public final class LayoutProblems {

    private LayoutProblems() {}

    /** What is cut, in words. */
    public static List<String> in(Container root) {
        List<String> problems = new ArrayList<>();
        check(root, problems);
        return problems;
    }

    private static void check(Container parent, List<String> problems) {
        for (Component child : parent.getComponents()) {
            if (!child.isVisible() || child.getWidth() == 0 && child.getHeight() == 0) {
                continue;
            }
            boolean scrolls = parent instanceof JViewport;
            Rectangle inside = new Rectangle(parent.getSize());
            if (!scrolls && isOutside(child.getBounds(), inside)) {
                problems.add(name(child) + " " + child.getBounds() + " is not inside " + name(parent) + " " + inside);
            }
            if (isCut(child)) {
                problems.add(name(child) + " is cut: " + child.getSize() + ", wants " + child.getPreferredSize());
            }
            // the insides of combo boxes and scroll bars are the look's own business
            if (child instanceof Container container && !(child instanceof JComboBox)) {
                check(container, problems);
            }
        }
    }

    private static boolean isOutside(Rectangle child, Rectangle parent) {
        return child.x < 0 || child.y < 0 || child.getMaxX() > parent.width || child.getMaxY() > parent.height;
    }

    private static boolean isCut(Component child) {
        if (child instanceof JTextArea area) {
            return area.getHeight() + 1 < area.getPreferredSize().height;
        }
        if (child instanceof JLabel label && !(child instanceof ShortLabel)) {
            return textWidth(label, label.getText()) > innerWidth(label);
        }
        if (child instanceof AbstractButton button
                && button.getText() != null
                && !button.getText().isEmpty()) {
            int icon = button.getIcon() == null ? 0 : button.getIcon().getIconWidth();
            return textWidth(button, button.getText()) + icon > button.getWidth()
                    || button.getHeight() + 1 < button.getPreferredSize().height;
        }
        return child instanceof JTextComponent text && text.getHeight() + 1 < text.getPreferredSize().height;
    }

    static int textWidth(JComponent component, String text) {
        FontMetrics metrics = component.getFontMetrics(component.getFont());
        return metrics.stringWidth(text);
    }

    static int innerWidth(JComponent component) {
        Insets insets = component.getInsets();
        return component.getWidth() - insets.left - insets.right;
    }

    private static String name(Component component) {
        String text = component instanceof JLabel label
                ? label.getText()
                : component instanceof AbstractButton button ? button.getText() : component.getName();
        return component.getClass().getSimpleName() + " \"" + text + "\"";
    }
}
