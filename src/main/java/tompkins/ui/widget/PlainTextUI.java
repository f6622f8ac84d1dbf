package tompkins.ui.widget;

import java.util.List;
import javax.swing.JComponent;
import javax.swing.UIDefaults;
import javax.swing.UIManager;
import javax.swing.plaf.ComponentUI;

/**
 * Makes all of Swing show text literally. Swing takes text that begins like HTML for HTML, and loads the pictures that
 * it names; but names and titles come from files, and files may come from anybody.
 *
 * <p>Every component asks for its delegate of the look and feel when it is made, before it has a text. This class
 * replaces all delegates: it makes the component show plain text, and hands it the delegate that it wanted.
 */
public final class PlainTextUI extends ComponentUI {

    private static final String NO_HTML = "html.disable";

    private PlainTextUI() {}

    /** Replaces all delegates of the look and feel, of the present one and of later ones. */
    static void install() {
        UIDefaults look = UIManager.getLookAndFeelDefaults();
        List<String> delegates = look.keySet().stream()
                .filter(key -> key instanceof String name && name.endsWith("UI") && look.get(name) instanceof String)
                .map(String.class::cast)
                .toList();
        delegates.forEach(delegate -> UIManager.put(delegate, PlainTextUI.class.getName()));
    }

    /** The delegate of a component, which Swing asks for. */
    public static ComponentUI createUI(JComponent component) {
        component.putClientProperty(NO_HTML, true);
        return UIManager.getLookAndFeelDefaults().getUI(component);
    }
}
