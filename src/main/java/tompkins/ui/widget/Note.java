package tompkins.ui.widget;

import java.awt.Color;
import javax.swing.JComponent;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import javax.swing.text.DefaultCaret;
import tompkins.property.InvalidPropertyException;

/** A text to read, as high as it needs: a paragraph, or a line of explanation or a message beneath a field. */
public final class Note {

    /** The font of explanations, which have a colour of their own. */
    private static final String EXPLANATION = "small.font";

    private final JTextArea area = new WrappingArea(0) {
        @Override
        public void updateUI() {
            super.updateUI();
            if (font == null) {
                // called once before there is a note
                return;
            }
            setFont(UIManager.getFont(font));
            setBorder(null);
            // a text that is not edited needs no caret that follows it
            ((DefaultCaret) getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
            setOpaque(false);
            setDisabledTextColor(colour());
            setForeground(colour());
        }
    };

    /** The key of its font. */
    private final String font;

    /** The message, and the text that is shown while there is none. */
    private Message said = new Message("", false);

    private Message usual = said;

    private record Message(String text, boolean isError) {}

    /** What it will say when the mouse is released; null if nothing. */
    private Runnable awaited;

    /** A note with a text; a note without text takes no room. */
    public Note(String text) {
        this(text, EXPLANATION);
    }

    private Note(String text, String font) {
        this.font = font;
        area.setEditable(false);
        area.setEnabled(false);
        area.setFocusable(false);
        area.updateUI();
        area.setVisible(false);
        setText(text);
    }

    /** A paragraph in the type and the colour of labels. */
    public static Note paragraph(String text) {
        return new Note(text, "Label.font");
    }

    /** A note that always has room for some lines, so that what is above does not move with its text. */
    public static Note ofLines(int lines) {
        return withLines(new Note(""), lines);
    }

    /** A result, in the largest type, which always has room for some lines. */
    public static Note result(int lines) {
        return withLines(new Note("", "large.font"), lines);
    }

    private static Note withLines(Note note, int lines) {
        note.area.setRows(lines);
        note.area.setVisible(true);
        return note;
    }

    /** The line itself, to be put into a panel. */
    public JComponent component() {
        return area;
    }

    /** What it says. */
    public String text() {
        return area.getText();
    }

    /** Shows an explanation; an empty one takes no room. */
    public void setText(String text) {
        say(new Message(text, false));
    }

    /** Says what is wrong. */
    public void setError(String message) {
        say(new Message("\u26A0 " + message, true));
    }

    /** Says this from now on whenever it has nothing else to say. */
    public void setUsual(String text) {
        usual = new Message(text, false);
        show();
    }

    /** As {@link #setUsual}, of something that is wrong. */
    public void setUsualError(String message) {
        usual = new Message("\u26A0 " + message, true);
        show();
    }

    /** As {@link #setError}, but not while the mouse is pressed: what is pressed must not move away from under it. */
    void setErrorAfterPress(String message) {
        afterPress(() -> setError(message));
    }

    /** As an empty {@link #setText}, but not while the mouse is pressed. */
    void clearAfterPress() {
        afterPress(() -> setText(""));
    }

    private void afterPress(Runnable change) {
        awaited = change;
        MousePress.afterwards(() -> {
            // unless it was given something else to say since
            if (awaited == change) {
                change.run();
            }
        });
    }

    private void say(Message message) {
        awaited = null;
        said = message;
        show();
    }

    private Message shown() {
        return said.text.isEmpty() ? usual : said;
    }

    private void show() {
        String text = shown().text;
        if (!area.getText().equals(text)) {
            area.setText(text);
            area.setVisible(area.getRows() > 0 || !text.isEmpty());
            area.revalidate();
        }
        area.setDisabledTextColor(colour());
        area.setForeground(colour());
    }

    /** Does something that may be refused, says why if it is, and returns whether it was done. */
    public boolean attempt(Runnable change) {
        try {
            change.run();
            setText("");
            return true;
        } catch (InvalidPropertyException wrong) {
            setError(Wording.message(wrong));
            return false;
        }
    }

    private Color colour() {
        return UIManager.getColor(
                shown().isError ? "Tompkins.error" : font.equals(EXPLANATION) ? "Tompkins.note" : "Label.foreground");
    }
}
