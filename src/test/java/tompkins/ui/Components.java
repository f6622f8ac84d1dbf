package tompkins.ui;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;

/** Finds components by their names, uses them as a hand does, and lays them out without a display. */
public final class Components {

    private static final int ROUNDS = 4;

    private Components() {}

    /** The component of a type that has a name. */
    public static <C extends Component> C find(Container root, Class<C> type, String name) {
        return all(root)
                .filter(type::isInstance)
                .map(type::cast)
                .filter(component -> name.equals(component.getName()))
                .findFirst()
                .orElseThrow(() -> new AssertionError("no " + type.getSimpleName() + " \"" + name + "\" among "
                        + all(root)
                                .map(Component::getName)
                                .filter(each -> each != null)
                                .toList()));
    }

    /** All components in a container, with those of its menus and of the windows that it owns. */
    public static Stream<Component> all(Container root) {
        List<Component> found = new ArrayList<>();
        collect(root, found);
        return found.stream();
    }

    /** Those of a type that are on the screen. */
    public static <C extends Component> Stream<C> showing(Container root, Class<C> type) {
        return all(root).filter(Component::isShowing).filter(type::isInstance).map(type::cast);
    }

    /** The texts of the labels. */
    public static Stream<String> labels(Container root) {
        return all(root).filter(JLabel.class::isInstance).map(label -> ((JLabel) label).getText());
    }

    /** The texts of the messages that are on the screen. */
    public static Stream<String> messages(Container root) {
        return showing(root, JTextArea.class)
                .filter(text -> "message".equals(text.getName()))
                .map(JTextArea::getText);
    }

    private static void collect(Component component, List<Component> found) {
        found.add(component);
        if (component instanceof JMenu menu) {
            collect(menu.getPopupMenu(), found);
        }
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                collect(child, found);
            }
        }
        if (component instanceof Window window) {
            for (Window owned : window.getOwnedWindows()) {
                collect(owned, found);
            }
        }
    }

    /** Types into a field and presses Enter. */
    public static JTextField enter(Container root, String name, String text) {
        JTextField field = find(root, JTextField.class, name);
        field.setText(text);
        field.postActionEvent();
        return field;
    }

    /** Presses a key in a field, such as "UP" or "shift DOWN". */
    public static void press(JTextComponent field, String key) {
        Object action = field.getInputMap().get(KeyStroke.getKeyStroke(key));
        field.getActionMap().get(action).actionPerformed(new ActionEvent(field, ActionEvent.ACTION_PERFORMED, key));
    }

    /** Gives the left button of the mouse to a place in a component. */
    public static void mouse(Component component, int event, int x, int y) {
        int down = event == MouseEvent.MOUSE_PRESSED ? InputEvent.BUTTON1_DOWN_MASK : 0;
        component.dispatchEvent(new MouseEvent(component, event, 0, down, x, y, 1, false, MouseEvent.BUTTON1));
    }

    /** Whether a field is marked as wrong. */
    public static boolean isMarked(JTextField field) {
        return FlatClientProperties.OUTLINE_ERROR.equals(field.getClientProperty(FlatClientProperties.OUTLINE));
    }

    /** The texts of the visible notes: explanations and messages. */
    public static List<String> notes(Container root) {
        return all(root)
                .filter(JTextArea.class::isInstance)
                .filter(Component::isVisible)
                .map(area -> ((JTextArea) area).getText())
                .toList();
    }

    /** Gives a component a width and the height that it wants then; heights of wrapped texts settle in some rounds. */
    public static void layOut(Component component, int width) {
        for (int round = 0; round < ROUNDS; round++) {
            component.setSize(new Dimension(width, Math.max(1, component.getPreferredSize().height)));
            layOut(component);
        }
    }

    /** Lays out a component of a given size with all that is in it. */
    public static void layOut(Component component) {
        component.invalidate();
        component.doLayout();
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                layOut(child);
            }
        }
    }
}
