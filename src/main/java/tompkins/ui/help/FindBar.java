package tompkins.ui.help;

import java.awt.Rectangle;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** A field for words, whatever their case: Enter goes to the next place in a text, and after the last to the first. */
final class FindBar extends Part {

    private static final int COLUMNS = 14;

    private final JTextComponent text;
    private final JTextField words = new JTextField(COLUMNS);
    private final JLabel found = new JLabel();

    /** A bar that searches a text. */
    FindBar(JTextComponent text) {
        super(Rows.of("gap 6", "push[]14[][]"));
        this.text = text;
        Naming.name(words, "help.find");
        found.setName("help.found");
        Keys.bindFocused(words, KeyStroke.getKeyStroke("ENTER"), this::goOn);
        panel.add(found);
        Rows.add(panel, Texts.get("help.find"), words, "");
    }

    /** Waits for words to be typed. */
    void begin() {
        words.selectAll();
        words.requestFocusInWindow();
    }

    private void goOn() {
        try {
            String all = text.getDocument().getText(0, text.getDocument().getLength());
            Matcher next = Pattern.compile(
                            Pattern.quote(words.getText()), Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE)
                    .matcher(all);
            boolean isFound = next.find(text.getSelectionEnd()) || next.find(0);
            found.setText(isFound ? "" : Texts.get("help.notFound"));
            if (isFound) {
                text.select(next.start(), next.end());
                text.getCaret().setSelectionVisible(true);
                Rectangle place = text.modelToView2D(next.start()).getBounds();
                int height = text.getVisibleRect().height;
                text.scrollRectToVisible(new Rectangle(0, place.y - height / 2, 1, height));
            }
        } catch (BadLocationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
