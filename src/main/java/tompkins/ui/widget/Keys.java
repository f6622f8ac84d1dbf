package tompkins.ui.widget;

import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.JSplitPane;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;

/** Binds keys to what they do. */
public final class Keys {

    /** Leaves or stops what is going on. */
    static final KeyStroke ESCAPE = KeyStroke.getKeyStroke("ESCAPE");

    private static final KeyStroke ENTER = KeyStroke.getKeyStroke("ENTER");

    /** Takes what was typed into a field in which Enter begins another line. */
    static final KeyStroke CONTROL_ENTER = KeyStroke.getKeyStroke("ctrl ENTER");

    private Keys() {}

    /** A key of a menu on this system: on a Mac, Ctrl is Cmd. Without a display, it does not matter. */
    public static KeyStroke ofMenu(String key) {
        boolean command = !GraphicsEnvironment.isHeadless()
                && Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx() == InputEvent.META_DOWN_MASK;
        return KeyStroke.getKeyStroke(command ? key.replace("ctrl", "meta") : key);
    }

    /** Does something when a key is pressed in a window, unless what has the focus there uses that key itself. */
    public static void bind(JRootPane window, KeyStroke key, Runnable action) {
        bind(window, JComponent.WHEN_IN_FOCUSED_WINDOW, key, action);
    }

    /** Does something when Escape is pressed in a window; if a menu is open there, Escape closes that. */
    public static void bindEscape(JRootPane window, Runnable action) {
        bind(window, ESCAPE, () -> {
            if (isMenuOpen()) {
                MenuSelectionManager.defaultManager().clearSelectedPath();
            } else {
                action.run();
            }
        });
    }

    /** Does something when a key is pressed in a window; nothing behind a menu that is open there. */
    public static void bindUnlessMenuIsOpen(JRootPane window, KeyStroke key, Runnable action) {
        bind(window, key, () -> {
            if (!isMenuOpen()) {
                action.run();
            }
        });
    }

    /** Leaves the keys to the window that split panes have a use of their own for. */
    public static void freeForWindow(JSplitPane split) {
        for (String key : new String[] {"F6", "F8"}) {
            split.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(key), "none");
        }
    }

    private static boolean isMenuOpen() {
        return MenuSelectionManager.defaultManager().getSelectedPath().length > 0;
    }

    /** Does something when a key is pressed in a component that has the focus. */
    public static void bindFocused(JComponent component, KeyStroke key, Runnable action) {
        bind(component, JComponent.WHEN_FOCUSED, key, action);
    }

    /** Does something when Enter is pressed anywhere in a component, unless what has the focus there uses it itself. */
    public static void bindEnter(JComponent component, Runnable action) {
        bind(component, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, ENTER, action);
    }

    /** Whether a letter was typed with Ctrl, such as + in Ctrl and +, and so belongs to a key of the menus. */
    private static boolean isMenuKey(KeyStroke key, ActionEvent event) {
        return key.getKeyEventType() == KeyEvent.KEY_TYPED
                && (event.getModifiers() & (ActionEvent.CTRL_MASK | ActionEvent.META_MASK)) != 0;
    }

    private static void bind(JComponent component, int condition, KeyStroke key, Runnable action) {
        component.getInputMap(condition).put(key, key);
        component.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                if (!isMenuKey(key, event)) {
                    action.run();
                }
            }
        });
    }
}
