package tompkins.ui.widget;

import javax.swing.JComponent;
import javax.swing.UIManager;
import javax.swing.text.DefaultCaret;

/** A text to read, wrapped between words and as high as it then needs to be. */
public final class Paragraph {

    private final WrappingArea area = new WrappingArea(0) {
        @Override
        public void updateUI() {
            super.updateUI();
            setFont(UIManager.getFont("Label.font"));
            setBorder(null);
            ((DefaultCaret) getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
            setOpaque(false);
            setDisabledTextColor(UIManager.getColor("Label.foreground"));
        }
    };

    /** A paragraph with a text; without one it takes no room. */
    public Paragraph(String text) {
        area.setEditable(false);
        area.setEnabled(false);
        area.setFocusable(false);
        area.updateUI();
        setText(text);
    }

    /** The paragraph itself, to be put into a panel. */
    public JComponent component() {
        return area;
    }

    /** Shows another text. */
    public void setText(String text) {
        area.setText(text);
        area.setVisible(!text.isEmpty());
        area.revalidate();
    }
}
