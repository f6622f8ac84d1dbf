package tompkins.ui;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import tompkins.studio.Studio;

/**
 * The studio that the window shows, with all that it was before. A panel never changes a studio: it proposes another one.
 * Used by the event thread alone.
 */
final class StudioModel {

    /** What one step of the history holds: a studio and where it was read from. */
    record Document(Studio studio, Path file) {}

    private static final int LONGEST_HISTORY = 1000;

    private final List<Runnable> listeners = new ArrayList<>();
    private final Deque<Document> past = new ArrayDeque<>();
    private final Deque<Document> future = new ArrayDeque<>();
    private Document current;
    private Document opened;
    private Object gesture;

    /** A model of a studio; the file may be null. */
    StudioModel(Studio studio, Path file) {
        current = new Document(studio, file);
        opened = current;
    }

    /** Calls the listener after every change. */
    void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** The studio as it is now. */
    Studio studio() {
        return current.studio();
    }

    /** The file of the studio, or null. */
    Path file() {
        return current.file();
    }

    /** The studio as it was opened or last saved. */
    Studio opened() {
        return opened.studio();
    }

    /** Whether the studio differs from what was opened or saved. */
    boolean isModified() {
        return !current.studio().equals(opened.studio());
    }

    /** Takes another studio, as a step that can be undone. */
    void set(Studio studio) {
        change(new Document(studio, current.file()), null);
    }

    /**
     * Takes another studio while a slider is dragged or an animation runs: all changes of one gesture that follow each other
     * are undone in one step.
     */
    void adjust(Studio studio, Object duringGesture) {
        change(new Document(studio, current.file()), duringGesture);
    }

    /** The next change begins a step of its own. */
    void endGesture() {
        gesture = null;
    }

    /** Takes a studio that was read from a file, as a step that can be undone. */
    void open(Studio studio, Path file) {
        Document document = new Document(studio, file);
        opened = document;
        change(document, null);
    }

    /** The studio was saved to a file as it is. */
    void saved(Path file) {
        current = new Document(current.studio(), file);
        opened = current;
        tellListeners();
    }

    /** Takes the studio as it was when it was opened or last saved. */
    void reset() {
        change(opened, null);
    }

    boolean canUndo() {
        return !past.isEmpty();
    }

    boolean canRedo() {
        return !future.isEmpty();
    }

    /** Takes the last step back, if there is one. */
    void undo() {
        move(past, future);
    }

    /** Takes the step again that was taken back last, if there is one. */
    void redo() {
        move(future, past);
    }

    private void move(Deque<Document> from, Deque<Document> to) {
        if (from.isEmpty()) {
            return;
        }
        to.push(current);
        current = from.pop();
        gesture = null;
        tellListeners();
    }

    private void change(Document next, Object duringGesture) {
        boolean continues = duringGesture != null && Objects.equals(duringGesture, gesture);
        gesture = duringGesture;
        if (next.equals(current)) {
            return;
        }
        if (!continues) {
            past.push(current);
            if (past.size() > LONGEST_HISTORY) {
                past.removeLast();
            }
        }
        future.clear();
        current = next;
        tellListeners();
    }

    private void tellListeners() {
        List.copyOf(listeners).forEach(Runnable::run);
    }
}
