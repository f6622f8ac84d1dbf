package tompkins.ui.widget;

import javax.swing.JButton;

/** Buttons with the text of a key, and the tooltip of that key with {@code Tip} appended. */
public final class Buttons {

    private Buttons() {}

    /** A button that does something. */
    public static JButton of(String key, Runnable action) {
        JButton button = new JButton(Texts.get(key));
        Naming.name(button, key);
        button.addActionListener(event -> action.run());
        return button;
    }
}
