package tompkins.ui;

import java.awt.Window;
import java.util.List;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.EntryField;

/**
 * Undo and redo as a person sees them: what stands in a field of the window without having been taken is the last thing that
 * was done, though the model knows nothing of it.
 */
final class History {

    private final StudioModel model;
    private final Window window;
    private final Runnable otherScene;

    /**
     * The history.
     *
     * @param otherScene told that a step led to a scene that was open before, or after
     */
    History(StudioModel model, Window window, Runnable otherScene) {
        this.model = model;
        this.window = window;
        this.otherScene = otherScene;
    }

    boolean canUndo() {
        return model.canUndo() || !pending().isEmpty();
    }

    boolean canRedo() {
        return model.canRedo();
    }

    boolean canReset() {
        return model.isModified() || !pending().isEmpty();
    }

    /** Takes back what was not taken; if there is nothing of that, the last step. */
    void undo() {
        List<EntryField> entries = pending();
        if (entries.isEmpty()) {
            step(model::undo);
        }
        entries.forEach(EntryField::revert);
    }

    void redo() {
        step(model::redo);
    }

    private void step(Runnable move) {
        Studio opened = model.opened();
        move.run();
        if (model.opened() != opened) {
            otherScene.run();
        }
    }

    /** Takes back what was not taken, and all that was since the studio was opened or saved. */
    void reset() {
        pending().forEach(EntryField::revert);
        model.reset();
    }

    private List<EntryField> pending() {
        return EntryField.in(window).filter(EntryField::isPending).toList();
    }
}
