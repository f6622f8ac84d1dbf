package tompkins.ui.model;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.math.RigidMotion;
import tompkins.measure.LessonStudio;
import tompkins.studio.LensEvent;
import tompkins.studio.Studio;
import tompkins.ui.widget.Faults;

/**
 * The studio that the window shows, with its history. A panel never changes a studio: it proposes another one. Used by
 * the event thread alone.
 */
public final class StudioModel {

    /**
     * What one step of the history holds.
     *
     * @param studio the studio
     * @param file where it was read from or saved to, or null
     * @param opened the studio as it was then
     * @param edited whether it was changed since, and not only looked at
     */
    private record Step(Studio studio, Path file, Studio opened, boolean edited) {

        Step editedTo(Studio other) {
            return new Step(other, file, opened, true);
        }

        Step seenAs(Studio other) {
            return new Step(other, file, opened, edited);
        }

        /** Whether another step changed the same opened studio. */
        boolean isOfSameFile(Step other) {
            return Objects.equals(file, other.file) && opened == other.opened;
        }
    }

    private static final int LONGEST_HISTORY = 1000;

    /** Those that keep up with what goes on by itself, and those that need not. */
    private final List<Consumer<Pace>> liveListeners = new ArrayList<>();

    private final List<Runnable> listeners = new ArrayList<>();

    /** Those that forget what belonged to another scene. */
    private final Deque<Runnable> openListeners = new ArrayDeque<>();

    private final Throttle throttle = new Throttle();
    private boolean untold;

    private final Deque<Step> past = new ArrayDeque<>();
    private final Deque<Step> future = new ArrayDeque<>();
    private Step current;

    /** The gestures that go on: an animation may run while a slider is dragged. */
    private final Set<Object> gestures = new HashSet<>();

    /** A model of a studio; the file may be null. */
    public StudioModel(Studio studio, Path file) {
        current = new Step(studio, file, studio, false);
    }

    /**
     * Calls the listener after every change; while the studio {@linkplain #flow flows}, five times a second at most,
     * and after its end.
     */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** Calls the listener now, and as {@link #addListener} after every change. */
    public void follow(Runnable listener) {
        addListener(listener);
        listener.run();
    }

    /**
     * Calls the listener after every change, however fast they come, and before others; it is told how soon a picture
     * of the change has to come.
     */
    public void addLiveListener(Consumer<Pace> listener) {
        liveListeners.add(listener);
    }

    /**
     * Calls the listener when a scene is opened, before those of changes. What is added last is called first: a whole
     * answers after its parts.
     */
    public void addOpenListener(Runnable listener) {
        openListeners.push(listener);
    }

    /** The studio as it is now. */
    public Studio studio() {
        return current.studio();
    }

    /** The file of the studio, or null. */
    public Path file() {
        return current.file();
    }

    /** The studio as it was opened or last saved. */
    public Studio opened() {
        return current.opened();
    }

    /**
     * Whether the camera of a studio, such as the present one, is where it was when this one was opened or last saved,
     * looks there and is as fast.
     */
    public boolean isAtHome(Studio studio) {
        Camera now = studio.camera();
        Camera home = opened().camera();
        return studio.velocity().equals(opened().velocity())
                && now.position().equals(home.position())
                && now.viewDirection().equals(home.viewDirection());
    }

    /** The studio with its camera where it was then, and when; what lens it has, and what is seen, stay. */
    public Studio atHome() {
        RigidMotion turn = CameraMotion.between(studio().camera(), opened().camera());
        return LensEvent.moved(studio(), LensEvent.inScene(opened()), opened().velocity(), turn.rotation());
    }

    /** The studio with the number that its lesson moves as it was then. */
    public Studio unmoved() {
        return LessonStudio.unmoved(studio(), opened());
    }

    /** Whether the studio differs from what was opened or saved. */
    public boolean isModified() {
        return !current.studio().equals(current.opened());
    }

    /** Whether the studio differs from what was opened or saved by more than where its camera was turned or ridden. */
    public boolean isEdited() {
        return isModified() && current.edited();
    }

    /** Takes another studio, as a step that can be undone. */
    public void set(Studio studio) {
        change(current.editedTo(studio), null, Pace.HAND);
    }

    /**
     * Takes another studio while a slider is dragged or an animation runs: all changes of one gesture are undone in one
     * step, with those of other gestures between them, up to a change that belongs to none.
     */
    public void adjust(Studio studio, Object duringGesture) {
        adjust(studio, duringGesture, Pace.HAND);
    }

    /** As above, where the picture has to come at another pace. */
    public void adjust(Studio studio, Object duringGesture, Pace pace) {
        change(current.editedTo(studio), duringGesture, pace);
    }

    /** As {@link #adjust}, while a hand turns or moves the camera: nobody needs to save that. */
    public void look(Studio studio, Object duringGesture) {
        change(current.seenAs(studio), duringGesture, Pace.HAND);
    }

    /**
     * As {@link #look}, of changes that follow each other by themselves faster than anybody reads: only the live
     * listeners are told of each. Whoever does so calls {@link #endGesture} in the end.
     */
    public void flow(Studio studio, Object duringGesture, Pace pace) {
        if (take(current.seenAs(studio), duringGesture)) {
            untold = true;
            tellLive(pace);
            if (throttle.admits()) {
                tellOthers();
            }
        }
    }

    /** The next change of this gesture begins a step of its own. */
    public void endGesture(Object gesture) {
        gestures.remove(gesture);
        if (untold) {
            tellOthers();
        }
    }

    /** Takes a studio that was read from a file, as a step that can be undone. */
    public void open(Studio studio, Path file) {
        boolean another = take(new Step(studio, file, studio, false), null);
        openListeners.forEach(StudioModel::tell);
        if (another) {
            tellListeners();
        }
    }

    /**
     * A studio was saved to a file: the present one, or one that it was a little while before. All steps since the
     * scene was opened, and those taken back, belong to that file from now on.
     */
    public void saved(Studio written, Path file) {
        Step before = current;
        UnaryOperator<Step> save = step -> step.isOfSameFile(before)
                ? new Step(
                        step.studio(),
                        file,
                        written,
                        step != before || !step.studio().equals(written))
                : step;
        replaceAll(past, save);
        replaceAll(future, save);
        current = save.apply(current);
        tellListeners();
    }

    private static void replaceAll(Deque<Step> steps, UnaryOperator<Step> change) {
        List<Step> changed = steps.stream().map(change).toList();
        steps.clear();
        steps.addAll(changed);
    }

    /** Takes the studio as it was when it was opened or last saved. */
    public void reset() {
        change(current.seenAs(current.opened()), null, Pace.HAND);
    }

    /** Whether there is a step to take back. */
    public boolean canUndo() {
        return !past.isEmpty();
    }

    /** Whether a step was taken back. */
    public boolean canRedo() {
        return !future.isEmpty();
    }

    /** Takes the last step back, if there is one. */
    public void undo() {
        move(past, future);
    }

    /** Repeats the step that was last taken back, if there is one. */
    public void redo() {
        move(future, past);
    }

    private void move(Deque<Step> from, Deque<Step> to) {
        if (from.isEmpty()) {
            return;
        }
        to.push(current);
        current = from.pop();
        gestures.clear();
        tellListeners();
    }

    /** Takes a step of a gesture, or of none if that is null. */
    private void change(Step next, Object gesture, Pace pace) {
        if (take(next, gesture)) {
            tellLive(pace);
            tellOthers();
        }
    }

    /** False if it is no change. */
    private boolean take(Step next, Object gesture) {
        if (next.equals(new Step(current.studio(), current.file(), current.opened(), next.edited()))) {
            return false;
        }
        if (gesture == null) {
            gestures.clear();
        }
        if (gesture == null || gestures.add(gesture)) {
            past.push(current);
            if (past.size() > LONGEST_HISTORY) {
                past.removeLast();
            }
        }
        future.clear();
        current = next;
        return true;
    }

    private void tellListeners() {
        tellLive(Pace.HAND);
        tellOthers();
    }

    private void tellLive(Pace pace) {
        liveListeners.forEach(listener -> tell(() -> listener.accept(pace)));
    }

    private void tellOthers() {
        untold = false;
        List.copyOf(listeners).forEach(StudioModel::tell);
    }

    private static void tell(Runnable listener) {
        try {
            listener.run();
        } catch (RuntimeException fault) {
            // the studio has changed: the others must know, and whoever changed it goes on
            Faults.tell(fault);
        }
    }
}
