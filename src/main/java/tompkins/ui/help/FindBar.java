package tompkins.ui.help;

import java.awt.Rectangle;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultHighlighter;
import javax.swing.text.JTextComponent;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.TextChanges;
import tompkins.ui.widget.Texts;

/**
 * Finds words in a text, whatever their case: marks all places, and goes from one to the next and after the last to the
 * first.
 */
final class FindBar extends Part {

    private static final int COLUMNS = 14;

    private final JTextComponent text;
    private final JTextField words = new JTextField(COLUMNS);
    private final JLabel count = new JLabel();
    private final JButton previous = Buttons.of("help.previous", () -> go(-1));
    private final JButton next = Buttons.of("help.next", () -> go(1));
    private List<MatchResult> places = List.of();
    private int current;

    /** A bar that searches a text. */
    FindBar(JTextComponent text) {
        super(Rows.of("gap 6", "push[]14[][][][]"));
        this.text = text;
        Naming.name(words, "help.find");
        count.setName("help.found");
        words.getDocument().addDocumentListener(new TextChanges(event -> search()));
        Keys.bindFocused(words, KeyStroke.getKeyStroke("ENTER"), () -> go(1));
        Keys.bindFocused(words, KeyStroke.getKeyStroke("shift ENTER"), () -> go(-1));
        Keys.bindFocused(words, KeyStroke.getKeyStroke("ESCAPE"), this::end);
        panel.add(count);
        Rows.add(panel, Texts.get("help.find"), words, "");
        panel.add(previous);
        panel.add(next);
        show();
    }

    /** Waits for words to be typed. */
    void begin() {
        words.selectAll();
        words.requestFocusInWindow();
    }

    /** Searches another text from its beginning. */
    void searchAgain() {
        find();
        current = 0;
        show();
    }

    /** Goes to the first place in view or below. */
    private void search() {
        find();
        current = places.isEmpty() ? 0 : firstInView();
        go(0);
    }

    private void find() {
        Pattern wanted =
                Pattern.compile(Pattern.quote(words.getText()), Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE);
        places = words.getText().isEmpty()
                ? List.of()
                : wanted.matcher(all()).results().toList();
    }

    private String all() {
        try {
            return text.getDocument().getText(0, text.getDocument().getLength());
        } catch (BadLocationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private int firstInView() {
        int top = text.viewToModel2D(text.getVisibleRect().getLocation());
        for (int place = 0; place < places.size(); place++) {
            if (places.get(place).start() >= top) {
                return place;
            }
        }
        return 0;
    }

    private void go(int step) {
        if (!places.isEmpty()) {
            current = Math.floorMod(current + step, places.size());
            scroll();
        }
        show();
    }

    private void end() {
        words.setText("");
        text.requestFocusInWindow();
    }

    private void show() {
        text.getHighlighter().removeAllHighlights();
        for (int place = 0; place < places.size(); place++) {
            mark(places.get(place), place == current ? "Tompkins.foundHere" : "Tompkins.found");
        }
        if (places.isEmpty()) {
            count.setText(words.getText().isEmpty() ? "" : Texts.get("help.notFound"));
        } else {
            count.setText(Texts.get("help.found", current + 1, places.size()));
        }
        previous.setEnabled(places.size() > 1);
        next.setEnabled(places.size() > 1);
    }

    private void mark(MatchResult place, String colour) {
        try {
            text.getHighlighter()
                    .addHighlight(
                            place.start(),
                            place.end(),
                            new DefaultHighlighter.DefaultHighlightPainter(UIManager.getColor(colour)));
        } catch (BadLocationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /** Brings the present place to the middle, if it is not in view. */
    private void scroll() {
        Rectangle seen = text.getVisibleRect();
        Rectangle place;
        try {
            place = text.modelToView2D(places.get(current).start()).getBounds();
        } catch (BadLocationException impossible) {
            throw new IllegalStateException(impossible);
        }
        if (!seen.contains(place)) {
            text.scrollRectToVisible(new Rectangle(0, place.y - seen.height / 2, 1, seen.height));
        }
    }
}
