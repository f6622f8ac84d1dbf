package tompkins.ui;

import java.util.List;
import tompkins.studio.Studio;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Texts;

/**
 * Undo and redo as a person sees them: what was typed into a field but not taken yet is the last thing that was done,
 * although the model does not know it.
 */
final class History {

    private final WindowParts window;
    private final Runnable pause;

    /**
     * The history.
     *
     * @param pause ends an animation, which would otherwise go on from what was taken back and lose what can be redone
     */
    History(WindowParts window, Runnable pause) {
        this.window = window;
        this.pause = pause;
    }

    boolean canUndo() {
        return window.model().canUndo() || !pending().isEmpty();
    }

    boolean canRedo() {
        return window.model().canRedo();
    }

    boolean canReset() {
        return window.model().isModified() || !pending().isEmpty();
    }

    /** Takes back what was typed into fields and not taken; if there is nothing of it, the last step. */
    void undo() {
        pause.run();
        List<EntryField> typed = pending();
        if (typed.isEmpty()) {
            step(window.model()::undo);
        }
        typed.forEach(EntryField::revert);
    }

    void redo() {
        takeEntries();
        step(window.model()::redo);
    }

    private void takeEntries() {
        pause.run();
        EntryField.takeAll(window.frame());
    }

    private void step(Runnable move) {
        Studio opened = window.model().opened();
        move.run();
        if (window.model().opened() != opened) {
            pending().forEach(EntryField::revert);
            // which may not have been meant; the pin belongs to its scene
            window.view().setPin(null);
            window.status()
                    .report(Texts.get(
                            "history.otherScene", window.model().studio().title()));
        }
    }

    /** Takes back everything that was done since the studio was opened or saved. */
    void reset() {
        takeEntries();
        pending().forEach(EntryField::revert);
        window.model().reset();
    }

    private List<EntryField> pending() {
        return EntryField.in(window.frame()).filter(EntryField::isPending).toList();
    }
}
