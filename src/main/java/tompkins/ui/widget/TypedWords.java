package tompkins.ui.widget;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.event.ActionEvent;
import java.util.ArrayDeque;
import java.util.Deque;
import javax.swing.AbstractAction;
import javax.swing.event.DocumentEvent;
import javax.swing.text.JTextComponent;

/**
 * Remembers what is typed into a text, word by word: the keys of undo and redo take back the last word and bring it
 * back. If there is no word, they do what they do elsewhere.
 */
final class TypedWords {

    /** What is typed after such a pause is a word of its own. */
    private static final long PAUSE_NANOSECONDS = 1_000_000_000;

    private final JTextComponent text;
    private final Deque<String> past = new ArrayDeque<>();
    private final Deque<String> future = new ArrayDeque<>();
    private final Updating updating = new Updating();
    private String last = "";
    private DocumentEvent.EventType lastKind;
    private long lastTime;

    /**
     * The key or click of the last change; typing over a selection makes two changes, of which the first removes it.
     */
    private AWTEvent lastInput;

    /** The words of a text. */
    TypedWords(JTextComponent text) {
        this.text = text;
        text.getDocument().addDocumentListener(new TextChanges(event -> updating.unless(() -> change(event))));
        bind("ctrl Z", past, future);
        bind("ctrl shift Z", future, past);
        bind("ctrl Y", future, past);
    }

    private void bind(String key, Deque<String> from, Deque<String> to) {
        text.getInputMap().put(Keys.ofMenu(key), key);
        text.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                to.push(last);
                show(from.pop());
            }

            @Override
            public boolean isEnabled() {
                return !from.isEmpty();
            }
        });
    }

    /** Shows a text, with the caret after what has changed. */
    private void show(String now) {
        int end = 0;
        while (end < Math.min(now.length(), last.length())
                && now.charAt(now.length() - 1 - end) == last.charAt(last.length() - 1 - end)) {
            end++;
        }
        updating.during(() -> text.setText(now));
        text.setCaretPosition(now.length() - end);
        last = now;
        lastKind = null;
        lastInput = null;
    }

    private void change(DocumentEvent event) {
        String now = text.getText();
        long time = System.nanoTime();
        AWTEvent input = EventQueue.getCurrentEvent();
        boolean goesOn = event.getType() == lastKind
                && event.getLength() == 1
                && time - lastTime < PAUSE_NANOSECONDS
                && (lastKind == DocumentEvent.EventType.REMOVE
                        || !Character.isWhitespace(now.charAt(event.getOffset())));
        if (input != lastInput && !goesOn) {
            past.push(last);
        }
        future.clear();
        last = now;
        lastKind = event.getType();
        lastTime = time;
        lastInput = input;
    }

    /** Forgets all words: the present text was taken, or was not typed. */
    void forget() {
        past.clear();
        future.clear();
        last = text.getText();
        lastKind = null;
        lastInput = null;
    }
}
