package tompkins.ui.lesson;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JRadioButton;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.TestRun;
import tompkins.io.BundledScenes;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonControl;
import tompkins.lesson.LessonNumber;
import tompkins.lesson.Prediction;
import tompkins.lesson.RayReading;
import tompkins.measure.LessonResult;
import tompkins.measure.LessonStudio;
import tompkins.measure.Sketch;
import tompkins.property.Descriptions;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.spacetime.Event;
import tompkins.studio.LensEvent;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;
import tompkins.ui.Components;
import tompkins.ui.LayoutProblems;
import tompkins.ui.LightLook;
import tompkins.ui.WindowDriver;
import tompkins.ui.model.Settings;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

@LightLook
class LessonPanelTest {

    /** The widths of the panel that the texts have, in sizes of the type. */
    private static final double WIDTH = 22.5;

    private static final double SLIM = 22.5;

    /** The height that is left for the pages in a window of 1024 x 700; the slider stands below two of them. */
    private static final List<Double> HEIGHTS = List.of(26.0, 22.0, 22.0, 26.0);

    private final StudioModel model = new StudioModel(with(Lesson.DEFAULT), null);
    private final List<Studio> followed = new ArrayList<>();
    private final NotedStage stage = new NotedStage();
    private final Settings settings = new Settings((Path) null);
    private final LessonCourse course = new LessonCourse(settings, followed::add);
    private final LessonPanel panel = new LessonPanel(model, course, stage);

    /** The look may have been changed while no lesson was there. */
    @Test
    void theStripOfALaterLessonHasThePresentLook() {
        StudioModel later = new StudioModel(Studio.DEFAULT, null);
        JComponent strip = new LessonPanel(
                        later, new LessonCourse(new Settings((Path) null), studio -> {}), new NotedStage())
                .component();
        int before = new JButton().getFont().getSize();
        Look.PROJECTOR.install();
        SwingUtilities.updateComponentTreeUI(strip);
        later.set(with(Lesson.DEFAULT));
        List<Integer> sizes = buttonSizes(strip);
        Look.LIGHT.install();
        assertThat(sizes).hasSizeGreaterThan(5).allMatch(size -> size > before);
    }

    private static List<Integer> buttonSizes(JComponent strip) {
        return Components.all(strip)
                .filter(AbstractButton.class::isInstance)
                .map(button -> button.getFont().getSize())
                .toList();
    }

    private static Studio with(Lesson lesson) {
        return Descriptions.with(Studio.DEFAULT, "lesson", lesson);
    }

    private Container strip() {
        return panel.component();
    }

    private JButton next(String step) {
        return Components.find(strip(), JButton.class, Texts.get("lesson.next." + step));
    }

    private void choose(String name) {
        Components.find(strip(), JRadioButton.class, name).setSelected(true);
    }

    @Test
    void itIsSeenOnlyWhereThereIsALesson() {
        assertThat(panel.component().isVisible()).isTrue();
        model.open(Studio.DEFAULT, null);
        assertThat(panel.component().isVisible()).isFalse();
    }

    @Test
    void predictionsAreOfferedInTheirOwnOrder() throws IOException {
        for (Lesson lesson : ours().toList()) {
            JComponent page = new LessonQuestionPage(lesson, () -> {}).component();
            assertThat(Components.notes(page))
                    .containsSubsequence(
                            lesson.shuffled().stream().map(Prediction::text).toList());
        }
    }

    @Test
    void nobodyGoesOnWithoutAPrediction() {
        assertThat(next("LOOK").isEnabled()).isFalse();
        choose("Nothing.");
        assertThat(next("LOOK").isEnabled()).isFalse();
        choose(Texts.get("lesson.unsure"));
        assertThat(next("LOOK").isEnabled()).isTrue();
        next("LOOK").doClick();
        assertThat(Components.notes(strip())).contains("Your prediction (not sure): Nothing.");
    }

    @Test
    void theReasonTellsWhichPredictionIsRight() {
        go("Nothing.", "lesson.sure");
        assertThat(Components.labels(strip())).contains(Texts.get("lesson.wrongSure"));
        assertThat(Components.notes(strip()))
                .contains(
                        "The right answer: Something.", "Aberration crowds the scene towards the direction of motion.");
        assertThat(model.studio().velocity().speed())
                .as("what is explained is seen")
                .isEqualTo(0.9);
        Components.find(strip(), JButton.class, Texts.get("lesson.again")).doClick();
        assertThat(model.studio()).isEqualTo(model.opened());
        go("Something.", "lesson.unsure");
        assertThat(Components.labels(strip())).contains(Texts.get("lesson.right"));
    }

    private JToggleButton step(String step) {
        return Components.find(strip(), JToggleButton.class, Texts.get("lesson.step." + step));
    }

    /** To pages that were seen, but not to others, and not to another answer. */
    @Test
    void oneGoesBackAndForwardAgain() {
        assertThat(step("LOOK").isEnabled()).isFalse();
        go("Nothing.", "lesson.sure");
        assertThat(step("MEASURE").isEnabled()).isFalse();

        step("LOOK").doClick();

        assertThat(step("LOOK").isSelected()).isTrue();
        assertThat(next("REASON").isVisible()).isTrue();
        Components.enter(strip(), "Speed", "0.2");
        step("PREDICT").doClick();
        assertThat(Components.find(strip(), JRadioButton.class, "Something.").isEnabled())
                .isFalse();
        step("REASON").doClick();
        assertThat(model.studio().velocity().speed()).isEqualTo(0.9);
        assertThat(Components.labels(strip())).contains(Texts.get("lesson.wrongSure"));

        Components.find(strip(), JButton.class, Texts.get("lesson.again")).doClick();

        assertThat(step("PREDICT").isSelected()).isTrue();
        assertThat(step("LOOK").isEnabled()).isFalse();
        assertThat(Components.find(strip(), JRadioButton.class, "Something.").isEnabled())
                .isTrue();
    }

    @Test
    void openedAgainItBeginsWithTheQuestion() {
        go("Nothing.", "lesson.sure");
        model.open(model.opened(), null);
        panel.begin();
        assertThat(step("PREDICT").isSelected()).isTrue();
        assertThat(Components.find(strip(), JRadioButton.class, Texts.get("lesson.sure"))
                        .isSelected())
                .isFalse();
    }

    private void go(String prediction, String sureness) {
        choose(prediction);
        choose(Texts.get(sureness));
        next("LOOK").doClick();
        assertThat(next("REASON").isEnabled()).as("before it is moved").isFalse();
        Components.find(strip(), JSlider.class, "Speed, slider").setValue(500);
        next("REASON").doClick();
    }

    /** A lesson is finished with its last page, and then leads to the next one. */
    @Test
    void theLastPageLeadsToTheNextLesson() {
        Studio first = Descriptions.with(with(Lesson.DEFAULT), "title", "Lesson A: first");
        Studio second = Descriptions.with(with(Lesson.DEFAULT), "title", "Lesson B: second");
        course.setLessons(List.of(first, second));
        model.open(first, null);
        panel.begin();
        assertThat(Components.labels(strip())).contains("1 of 2, 0 done");
        go("Something.", "lesson.sure");
        assertThat(course.isFinished(first)).isFalse();
        next("MEASURE").doClick();
        WindowDriver.await("the numbers", () -> course.isFinished(first));
        assertThat(Components.labels(strip())).contains("1 of 2, 1 done");
        next("LESSON").doClick();
        assertThat(followed).containsExactly(second);
        assertThat(new LessonCourse(settings, studio -> {}).isFinished(first))
                .as("kept")
                .isTrue();
        model.open(second, null);
        panel.begin();
        assertThat(course.isFinished(second)).isFalse();
    }

    private static Studio lesson(String title) throws IOException {
        return BundledScenes.studios().stream()
                .filter(studio -> studio.title().startsWith(title))
                .findFirst()
                .orElseThrow();
    }

    private void answerAnything() {
        Components.all(strip())
                .filter(JRadioButton.class::isInstance)
                .forEach(button -> ((JRadioButton) button).setSelected(true));
        next("LOOK").doClick();
    }

    /** Of a lesson whose slider turns a wheel, when the wheel is gone. */
    @Test
    void aLessonWithoutItsObjectSaysSoAndIsNotDone() throws IOException {
        Studio lesson = lesson("Lesson 14:");
        course.setLessons(List.of(lesson));
        model.open(lesson, null);
        panel.begin();
        answerAnything();
        String lost = "\u26a0 " + Texts.get("lesson.lost");
        assertThat(Components.notes(strip()))
                .contains(Texts.get("lesson.lookHint"))
                .doesNotContain(lost);

        model.set(model.studio().withScene(List.of()));

        assertThat(Components.notes(strip())).contains(lost).doesNotContain(Texts.get("lesson.lookHint"));
        assertThat(next("REASON").isEnabled()).isFalse();
        model.undo();
        assertThat(Components.notes(strip())).contains(Texts.get("lesson.lookHint"));
        Components.all(strip()).filter(JSlider.class::isInstance).forEach(slider -> ((JSlider) slider).setValue(500));
        next("REASON").doClick();
        model.set(model.studio().withScene(List.of()));
        next("MEASURE").doClick();
        assertThat(Components.notes(strip())).anyMatch(note -> note.startsWith("\u26a0 "));
        assertThat(course.isFinished(lesson)).isFalse();
    }

    /** Whoever rides, waits or looks around meanwhile still gets the numbers of the lesson. */
    @ParameterizedTest
    @ValueSource(strings = {"Lesson 1:", "Lesson 5:", "Lesson 12:", "Lesson 13:"})
    void aCameraThatWentAwayMeasuresWhereTheLessonIs(String title) throws IOException {
        Studio lesson = lesson(title);
        for (Event way : List.of(new Event(0, 0, 0, 3.3), new Event(0.2, 0.1, -0.3, 1))) {
            model.open(lesson, null);
            panel.begin();
            answerAnything();
            JSlider slider = (JSlider) Components.all(strip())
                    .filter(JSlider.class::isInstance)
                    .findFirst()
                    .orElseThrow();
            slider.setValue(slider.getValue() == 500 ? 501 : 500);
            Studio present = model.studio();
            Event away = LensEvent.inScene(present).plus(way);
            model.look(LensEvent.moved(present, away, present.velocity(), new Quaterniond().rotateY(way.x())), this);
            next("REASON").doClick();
            assertThat(LessonStudio.of(model.studio()).orElseThrow().results())
                    .as("%s after %s", title, way)
                    .isNotEmpty()
                    .allMatch(LessonResult::agrees);
        }
    }

    @Test
    void aLessonWithoutNumbersEndsWithTheReason() {
        model.open(with(Descriptions.with(Lesson.DEFAULT, "numbers", List.of())), null);
        go("Something.", "lesson.sure");
        assertThat(Components.all(strip()).filter(JButton.class::isInstance).filter(Component::isVisible))
                .hasSize(1);
    }

    @Test
    void aLessonThatDoesNotFitSaysWhy() {
        LessonControl control = new LessonControl("scene[3].radius", "Radius", 1, 2, 2);
        model.open(with(Descriptions.with(Lesson.DEFAULT, "control", control)), null);
        assertThat(Components.notes(strip()))
                .singleElement()
                .satisfies(message ->
                        assertThat(message).contains("lesson.control.number: number must be the path of a number"));
    }

    @Test
    void theSliderRestsWhenItsNumberIsGone() {
        model.open(
                with(Descriptions.with(
                        Lesson.DEFAULT, "control", new LessonControl("camera.shutter.openingTime", "Time", 0, 2, 2))),
                null);
        JSlider slider = Components.find(strip(), JSlider.class, "Time, slider");
        assertThat(slider.isEnabled()).isTrue();
        model.set(model.studio().withCamera(model.studio().camera().withShutter(FixedPointSurfaceShutter.DEFAULT)));
        assertThat(slider.isEnabled()).isFalse();
    }

    static Stream<Arguments> lessonsInAllLooks() throws IOException {
        List<Lesson> lessons = BundledScenes.studios().stream()
                .map(Studio::lesson)
                .filter(Lesson.class::isInstance)
                .map(Lesson.class::cast)
                .toList();
        assertThat(lessons).hasSizeGreaterThan(11);
        return Stream.concat(
                Stream.of(TestRun.THOROUGH ? Look.values() : new Look[] {Look.LIGHT, Look.PROJECTOR})
                        .flatMap(look -> lessons.stream().map(lesson -> Arguments.of(look, lesson))),
                // the large type of the projector asks for shorter texts
                Stream.of(Look.LIGHT, Look.DARK).map(look -> Arguments.of(look, longest())));
    }

    /** Texts as long as they may be. */
    private static Lesson longest() {
        LessonNumber number = new LessonNumber(text(45), RayReading.DEFAULT, text(40), -0.123456, 1e-6, text(12));
        return new Lesson(
                text(300),
                Collections.nCopies(4, new Prediction(text(110), text(200))),
                1,
                new LessonControl("velocity.beta", text(40), 0, 0.9, 0.5),
                text(450),
                text(160),
                text(200),
                Collections.nCopies(4, number));
    }

    private static String text(int letters) {
        return "as long as texts may be, and so on, ".repeat(20).substring(0, letters);
    }

    /** Each page of our lessons is in sight without scrolling; the texts of others may be longer. */
    @ParameterizedTest(name = "{index}")
    @MethodSource("lessonsInAllLooks")
    void everyPageIsInSight(Look look, Lesson lesson) {
        WindowDriver.onEventThread(() -> {
            look.install(1);
            SwingUtilities.updateComponentTreeUI(strip());
            model.open(with(lesson), null);
            Prediction wrong = lesson.predictions()
                    .get(lesson.right() % lesson.predictions().size());
            int width = Look.pixels(look == Look.PROJECTOR ? SLIM : WIDTH);
            List<JComponent> pages = pages(lesson, wrong);
            for (JComponent page : pages) {
                Components.layOut(page, width);
                assertThat(LayoutProblems.in(page)).isEmpty();
                if (look == Look.PROJECTOR) {
                    assertThat(page.getHeight())
                            .as("page %d of “%s”", pages.indexOf(page), lesson.question())
                            .isLessThan(Look.pixels(HEIGHTS.get(pages.indexOf(page))));
                }
            }
            Components.layOut(strip(), width);
            assertThat(LayoutProblems.in(strip())).isEmpty();
        });
    }

    /** Nobody can tell the right answer from its place. */
    @Test
    void theRightAnswersHaveAllPlaces() throws IOException {
        List<Integer> places = ours().map(lesson -> {
                    List<Prediction> offered = lesson.shuffled();
                    assertThat(offered).containsExactlyInAnyOrderElementsOf(lesson.predictions());
                    assertThat(lesson.shuffled()).as("always the same").isEqualTo(offered);
                    return offered.indexOf(lesson.predictions().get(lesson.right() - 1));
                })
                .toList();
        assertThat(IntStream.range(0, 3)).allMatch(place -> Collections.frequency(places, place) >= places.size() / 4);
    }

    static Stream<Lesson> ours() throws IOException {
        return BundledScenes.studios().stream()
                .map(Studio::lesson)
                .filter(Lesson.class::isInstance)
                .map(Lesson.class::cast);
    }

    /** All pages, after a sure answer. */
    private List<JComponent> pages(Lesson lesson, Prediction chosen) {
        LessonQuestionPage.Answer answer = new LessonQuestionPage.Answer(chosen, true);
        LessonReasonPage reason = new LessonReasonPage(lesson, false, shown -> {}, value -> {}, null);
        reason.show(answer);
        LessonNumbersPage numbers = new LessonNumbersPage(lesson);
        numbers.show(lesson.numbers().stream()
                .map(number -> new LessonResult(number, number.value(), Sketch.EMPTY))
                .toList());
        LessonLookPage lookPage = new LessonLookPage(() -> {});
        lookPage.show(answer);
        return List.of(
                new LessonQuestionPage(lesson, () -> {}).component(),
                lookPage.component(),
                reason.component(),
                numbers.component());
    }

    /** The question comes back, too, and what was drawn is gone with the page. */
    @Test
    void theReasonHasTwoMorePictures() {
        go("Nothing.", "lesson.sure");
        JToggleButton other = Components.find(strip(), JToggleButton.class, Texts.get("lesson.otherPicture"));
        other.doClick();
        assertThat(model.studio().velocity().isRest()).isTrue();
        other.doClick();
        assertThat(model.studio().velocity().speed()).isEqualTo(0.9);
        stage.outlines.clear();
        Components.find(strip(), JToggleButton.class, Texts.get("lesson.outlines"))
                .doClick();
        next("MEASURE").doClick();
        assertThat(stage.outlines).containsExactly(true, false);
    }

    @Test
    void theOtherShutterComesAfterTheQuestion() throws IOException {
        model.open(BundledScenes.studio("lesson-12-shutter.json"), null);
        panel.begin();
        assertThat(stage.compared).isEmpty();
        choose("Both of them.");
        choose(Texts.get("lesson.sure"));
        next("LOOK").doClick();
        assertThat(stage.compared).containsExactly(DetectorPlaneShutter.class);
    }

    /** From home, wherever the slider is; and what is beyond its ends is not shown on it. */
    @Test
    void aRideIsFlownFromHome() throws IOException {
        Studio twins = BundledScenes.studio("lesson-18-twins.json");
        model.open(twins, null);
        panel.begin();
        choose("6 minutes.");
        choose(Texts.get("lesson.sure"));
        next("LOOK").doClick();
        JSlider slider = Components.find(strip(), JSlider.class, "Your watch on the way out (min), slider");
        slider.setValue(1000);
        Components.find(strip(), JButton.class, Texts.get("lesson.fly")).doClick();
        assertThat(stage.flights).isOne();
        assertThat(model.studio()).isEqualTo(twins);
        assertThat(next("REASON").isEnabled()).isTrue();
        assertThat(slider.getParent().isVisible()).isTrue();
        model.look(RideMoment.onRide(twins, 5).studio(), this);
        assertThat(isSeen(slider)).isFalse();
        assertThat(slider.getValue()).isZero();
    }

    private boolean isSeen(Component component) {
        return component == strip() || component.isVisible() && isSeen(component.getParent());
    }
}
