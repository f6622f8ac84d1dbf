package tompkins.ui.widget;

import com.formdev.flatlaf.FlatClientProperties;
import javax.swing.JComponent;
import javax.swing.JToggleButton;

/** A text of which the beginning is seen, and with a button all of it. */
public final class FoldedText {

    /** About two lines of a narrow panel. */
    private static final int BEGINNING = 90;

    private final Note note = new Note("");
    private final JToggleButton more = new JToggleButton();
    private String text = "";

    /** A folded text with a name, without words yet. */
    public FoldedText(String name) {
        note.component().setName(name);
        more.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
        more.putClientProperty(FlatClientProperties.STYLE, "font: $small.font; margin: 0,4,0,4; minimumWidth: 0");
        more.addItemListener(event -> fold());
        fold();
    }

    private void fold() {
        String key = more.isSelected() ? "remarks.less" : "remarks.more";
        more.setText(Texts.get(key));
        Naming.name(more, Texts.get(key), Texts.get("remarks.moreTip"));
        // the button is there where it has something to do
        more.setVisible(text.length() > BEGINNING);
        note.setText(more.isSelected() ? text : beginning());
    }

    /** The first words, with an ellipsis where more follow. */
    private String beginning() {
        int end = text.lastIndexOf(' ', BEGINNING);
        return text.length() <= BEGINNING || end < 0 ? text : text.substring(0, end) + " \u2026";
    }

    /** The text itself, to be put into a panel. */
    public JComponent component() {
        return note.component();
    }

    /** The button that unfolds it, to be put near it. */
    public JComponent button() {
        return more;
    }

    /** What it says, folded or not. */
    public String text() {
        return text;
    }

    /** Says something else, folded. */
    public void setText(String words) {
        text = words;
        more.setSelected(false);
        fold();
    }
}
