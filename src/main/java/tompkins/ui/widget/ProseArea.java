package tompkins.ui.widget;

import java.awt.event.ActionEvent;
import java.util.function.BooleanSupplier;
import javax.swing.AbstractAction;
import javax.swing.UIManager;
import javax.swing.undo.UndoManager;

/**
 * A field for text of several lines, as high as the text needs. While something was typed, the keys of undo and redo
 * take it back and bring it back; else they do what they do elsewhere.
 */
@SuppressWarnings("serial") // never written to a stream
public final class ProseArea extends WrappingArea {

    private static final int ROWS = 3;

    private final transient UndoManager typed = new UndoManager();

    /** An empty field. */
    public ProseArea() {
        super(ROWS);
        typed.setLimit(-1);
        getDocument().addUndoableEditListener(typed);
        bind("ctrl Z", typed::undo, typed::canUndo);
        bind("ctrl shift Z", typed::redo, typed::canRedo);
        bind("ctrl Y", typed::redo, typed::canRedo);
    }

    private void bind(String key, Runnable step, BooleanSupplier isPossible) {
        getInputMap().put(Keys.ofMenu(key), key);
        getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                step.run();
            }

            @Override
            public boolean isEnabled() {
                return isPossible.getAsBoolean();
            }
        });
    }

    /** Lets the keys of undo go back no further than the present text. */
    void forgetTyped() {
        typed.discardAllEdits();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(UIManager.getFont("TextField.font"));
        setBorder(UIManager.getBorder("TextField.border"));
        setMargin(UIManager.getInsets("TextField.margin"));
    }
}
