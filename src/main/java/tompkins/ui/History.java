package tompkins.ui;

import java.awt.Window;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.EntryField;

/**
 * Undo and redo as a person sees them: what was typed into a field but not taken yet is the last thing that was done,
 * although the model does not know it.
 */
final class History {

    private final StudioModel model;
    private final Window window;
    private final Runnable pause;
    private final Runnable otherScene;

    /**
     * The history.
     *
     * @param pause ends an animation, which would otherwise go on from what was taken back and lose what can be redone
     * @param otherScene told that a step led to another scene
     */
    History(StudioModel model, Window window, Runnable pause, Runnable otherScene) {
        this.model = model;
        this.window = window;
        this.pause = pause;
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

    /** Takes back what was typed last. If it is right it first becomes a step, so that it can be redone. */
    void undo() {
        Map<EntryField, String> typed =
                pending().stream().collect(Collectors.toMap(Function.identity(), EntryField::displayed));
        Studio before = model.studio();
        takeEntries();
        boolean isStep = typed.isEmpty() || model.studio() != before;
        if (isStep && pending().isEmpty()) {
            step(model::undo);
        }
        pending().forEach(EntryField::revert);
        if (!isStep) {
            // of the animation, for instance, which is not part of the scene
            typed.forEach(EntryField::enter);
        }
    }

    void redo() {
        takeEntries();
        step(model::redo);
    }

    private void takeEntries() {
        pause.run();
        EntryField.takeAll(window);
    }

    private void step(Runnable move) {
        Studio opened = model.opened();
        move.run();
        if (model.opened() != opened) {
            pending().forEach(EntryField::revert);
            otherScene.run();
        }
    }

    /** Takes back everything that was done since the studio was opened or saved. */
    void reset() {
        takeEntries();
        pending().forEach(EntryField::revert);
        model.reset();
    }

    private List<EntryField> pending() {
        return EntryField.in(window).filter(EntryField::isPending).toList();
    }
}
