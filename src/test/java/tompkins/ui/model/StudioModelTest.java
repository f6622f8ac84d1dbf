package tompkins.ui.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;

class StudioModelTest {

    private final StudioModel model = new StudioModel(speed(0), null);

    private static Studio speed(double beta) {
        return Studio.DEFAULT.withVelocity(Velocity.of(0, 0, beta));
    }

    /** Whoever only looked around is not asked about changes. */
    @Test
    void lookingIsNoEdit() {
        StudioModel model = new StudioModel(speed(0), null);
        Object hand = new Object();
        model.look(speed(0.1), hand);
        model.flow(speed(0.2), hand, Pace.RIDE);
        model.endGesture(hand);
        assertThat(model.isModified()).isTrue();
        assertThat(model.isEdited()).isFalse();
        model.set(speed(0.3));
        model.look(speed(0.4), hand);
        assertThat(model.isEdited()).isTrue();
        model.undo();
        model.undo();
        assertThat(model.isEdited()).as("as before the edit").isFalse();
        model.redo();
        assertThat(model.isEdited()).isTrue();
        model.saved(model.studio(), Path.of("a.json"));
        model.look(speed(0.5), hand);
        assertThat(model.isEdited()).as("after saving").isFalse();
    }

    @Test
    void everyStepCanBeTakenBackAndAgain() {
        model.set(speed(0.1));
        model.set(speed(0.2));
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0.1));
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0));
        assertThat(model.canUndo()).isFalse();
        model.undo();
        model.redo();
        model.redo();
        assertThat(model.studio()).isEqualTo(speed(0.2));
        assertThat(model.canRedo()).isFalse();
    }

    @Test
    void aDragIsOneStep() {
        Object drag = new Object();
        model.adjust(speed(0.1), drag);
        model.adjust(speed(0.2), drag);
        model.adjust(speed(0.3), drag);
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0));
    }

    @Test
    void theLiveListenersAreToldThePace() {
        List<Pace> paces = new ArrayList<>();
        model.addLiveListener(paces::add);
        Object gesture = new Object();
        model.set(speed(0.1));
        model.flow(speed(0.2), gesture, Pace.ANSWER);
        model.flow(speed(0.3), gesture, Pace.RIDE);
        model.adjust(speed(0.4), gesture, Pace.FILM);
        model.undo();
        assertThat(paces).containsExactly(Pace.HAND, Pace.ANSWER, Pace.RIDE, Pace.FILM, Pace.HAND);
    }

    /** What is put together from parts answers after them, and the changes follow. */
    @Test
    void theLastListenerIsToldFirstOfAnotherScene() {
        List<String> told = new ArrayList<>();
        model.addOpenListener(() -> told.add("window"));
        model.addOpenListener(() -> told.add("part " + model.studio().velocity().speed()));
        model.addListener(() -> told.add("change"));
        model.set(speed(0.1));
        model.open(speed(0.2), null);
        // the same scene once more is opened, too
        model.open(model.opened(), null);
        assertThat(told).containsExactly("change", "part 0.2", "window", "change", "part 0.2", "window");
    }

    @Test
    void onlyLiveListenersKeepUpWithAFlow() {
        List<Double> live = new ArrayList<>();
        List<Double> others = new ArrayList<>();
        model.addListener(() -> others.add(model.studio().velocity().speed()));
        model.addLiveListener(pace -> live.add(model.studio().velocity().speed()));
        Object ride = new Object();
        for (int i = 1; i <= 9; i++) {
            model.flow(speed(i / 16.0), ride, Pace.RIDE);
        }
        assertThat(live).hasSize(9);
        // at once, and never again in a moment as short as this
        assertThat(others).startsWith(1 / 16.0).hasSizeLessThan(9);
        model.endGesture(ride);
        assertThat(others).endsWith(9 / 16.0);
        int told = others.size();
        model.endGesture(ride);
        assertThat(others).hasSize(told);
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0));
        assertThat(others).endsWith(0.0);
    }

    /** As an animation does whose first moment is what is shown. */
    @Test
    void aDragFromTheSameValueIsAStepOfItsOwn() {
        Object drag = new Object();
        model.set(speed(0.1));
        model.adjust(speed(0.1), drag);
        model.adjust(speed(0.2), drag);
        model.adjust(speed(0.2), drag);
        model.adjust(speed(0.3), drag);
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0.1));
    }

    @Test
    void twoDragsOfOneSliderAreTwoSteps() {
        Object drag = new Object();
        model.adjust(speed(0.1), drag);
        model.endGesture(drag);
        model.adjust(speed(0.2), drag);
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0.1));
    }

    /** Such as the keys of a slider while an animation runs, whose ticks make no steps. */
    @Test
    void theEndOfOneGestureIsNotThatOfAnother() {
        Object animation = new Object();
        Object drag = new Object();
        model.adjust(speed(0.1), animation);
        model.adjust(speed(0.2), drag);
        model.endGesture(drag);
        model.adjust(speed(0.3), animation);
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0.1));
    }

    /** Such as an animation that runs while a slider is dragged. */
    @Test
    void twoGesturesAtATimeAreTwoSteps() {
        Object animation = new Object();
        Object drag = new Object();
        model.adjust(speed(0.1), animation);
        for (int i = 0; i < 1500; i++) {
            model.adjust(speed(0.2 + i * 1e-4), i % 2 == 0 ? drag : animation);
        }
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0.1));
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0));
    }

    @Test
    void aChangeOfItsOwnEndsAllGestures() {
        Object drag = new Object();
        model.adjust(speed(0.1), drag);
        model.set(speed(0.2));
        model.adjust(speed(0.3), drag);
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0.2));
    }

    /** The scene may go on changing while the file is written. */
    @Test
    void whatWasSavedALittleWhileAgoHasItsFileToo() {
        Object animation = new Object();
        model.adjust(speed(0.1), animation);
        Studio written = model.studio();
        model.adjust(speed(0.2), animation);
        model.saved(written, Path.of("a.json"));
        assertThat(model.file()).isEqualTo(Path.of("a.json"));
        assertThat(model.isModified()).isTrue();
        model.reset();
        assertThat(model.studio()).isEqualTo(speed(0.1));
        assertThat(model.isModified()).isFalse();
    }

    @Test
    void aNewStepForgetsWhatWasTakenBack() {
        model.set(speed(0.1));
        model.undo();
        model.set(speed(0.2));
        assertThat(model.canRedo()).isFalse();
    }

    @Test
    void whatChangesNothingIsNoStep() {
        AtomicInteger told = new AtomicInteger();
        model.addListener(told::incrementAndGet);
        model.set(speed(0));
        assertThat(model.canUndo()).isFalse();
        assertThat(told).hasValue(0);
    }

    @Test
    void resetGoesBackToWhatWasOpenedAndCanBeUndone() {
        model.open(speed(0.5), Path.of("a.json"));
        model.set(speed(0.6));
        model.set(speed(0.7));
        assertThat(model.isModified()).isTrue();
        model.reset();
        assertThat(model.studio()).isEqualTo(speed(0.5));
        assertThat(model.isModified()).isFalse();
        model.undo();
        assertThat(model.studio()).isEqualTo(speed(0.7));
    }

    @Test
    void undoOfOpeningGoesBackToTheFileBefore() {
        model.saved(model.studio(), Path.of("first.json"));
        model.open(speed(0.5), Path.of("second.json"));
        model.undo();
        assertThat(model.file()).isEqualTo(Path.of("first.json"));
        assertThat(model.studio()).isEqualTo(speed(0));
        assertThat(model.isModified()).isFalse();
        model.set(speed(0.1));
        model.reset();
        assertThat(model.studio()).isEqualTo(speed(0));
        model.undo();
        model.undo();
        model.redo();
        model.redo();
        assertThat(model.studio()).isEqualTo(speed(0));
        assertThat(model.file()).isEqualTo(Path.of("first.json"));
    }

    @Test
    void undoneAfterSavingElsewhereIsOfTheNewFile() {
        model.open(speed(0.5), Path.of("a.json"));
        model.set(speed(0.6));
        model.saved(model.studio(), Path.of("b.json"));
        model.undo();
        assertThat(model.file()).isEqualTo(Path.of("b.json"));
        assertThat(model.studio()).isEqualTo(speed(0.5));
        assertThat(model.isModified()).isTrue();
        model.undo();
        assertThat(model.file()).as("the scene before it had no file").isNull();
        assertThat(model.isModified()).isFalse();
        model.redo();
        model.redo();
        assertThat(model.isModified()).isFalse();
        model.set(speed(0.7));
        model.reset();
        assertThat(model.studio()).isEqualTo(speed(0.6));
        assertThat(model.file()).isEqualTo(Path.of("b.json"));
    }
}
