package tompkins.ui.widget;

import java.util.function.Consumer;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/**
 * Tells of each change of a plain text.
 *
 * @param listener notified of a change while the text must not be changed again
 */
public record TextChanges(Consumer<DocumentEvent> listener) implements DocumentListener {

    @Override
    public void insertUpdate(DocumentEvent event) {
        listener.accept(event);
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
        listener.accept(event);
    }

    @Override
    public void changedUpdate(DocumentEvent styles) {
        // plain text has none
    }
}
