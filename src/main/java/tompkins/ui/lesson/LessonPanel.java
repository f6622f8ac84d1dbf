package tompkins.ui.lesson;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import tompkins.io.FactText;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonPlan;
import tompkins.lesson.NoLesson;
import tompkins.measure.LessonResult;
import tompkins.measure.LessonStudio;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.shutter.Shutter;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.model.StudioModel;
import tompkins.ui.ray.DiagramWindow;
import tompkins.ui.ray.SpaceTimeDiagram;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.ChoiceRow;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** A lesson beside its picture. It leads from page to page: predict, look, learn why, measure. */
public final class LessonPanel extends Part {

    /** The pages, in their order. */
    private enum Step {
        PREDICT,
        LOOK,
        REASON,
        MEASURE
    }

    private final StudioModel model;
    private final LessonCourse course;
    private final LessonStage stage;
    private final JPanel head = Rows.of("hidemode 3, gap 2", "[]".repeat(Step.values().length) + "push[]");
    private final JPanel foot = Rows.of("gap 6", "[grow,fill][]");
    private final JButton again = Buttons.of("lesson.again", this::startAgain);
    private final Map<Step, JToggleButton> steps = new EnumMap<>(Step.class);
    private final JButton next = new JButton();
    private final JLabel progress = new JLabel();
    private final Note problem = new Note("");

    /** Holds the pages, of which one is seen. */
    private final JPanel pageRoom = Rows.column();

    private final Map<Step, Part> pages = new EnumMap<>(Step.class);

    /** Holds the slider of the lesson, which stays while the pages change. */
    private final JPanel sliderRoom = Rows.column();

    private final Note remarks = new Note("");
    private final DiagramWindow diagram = new DiagramWindow();

    /** What it was made for. */
    private LessonPlan shown = NoLesson.DEFAULT;

    private LessonStudio lesson;

    /** The studio in which was measured, until another one is there; null before. */
    private Studio measured;

    private Step step = Step.PREDICT;

    /** The last page that was seen: from there one can go back, and forward again. */
    private Step farthest = Step.PREDICT;

    private LessonQuestionPage question;
    private LessonLookPage look;
    private LessonSlider slider;
    private LessonReasonPage reason;

    /** Whether the ride was flown, which shows more than the slider. */
    private boolean flown;

    private LessonNumbersPage numbers;

    /** The lesson, invisible as long as the studio of the model has none. */
    public LessonPanel(StudioModel model, LessonCourse course, LessonStage stage) {
        super(Rows.column());
        this.model = model;
        this.course = course;
        this.stage = stage;
        progress.putClientProperty(FlatClientProperties.STYLE, "font: $small.font");
        ButtonGroup group = new ButtonGroup();
        for (Step each : Step.values()) {
            JToggleButton button = new JToggleButton(Texts.get("lesson.step." + each));
            Naming.name(button, "lesson.step." + each);
            button.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
            ChoiceRow.whenChosen(button, () -> choose(each));
            group.add(button);
            steps.put(each, button);
            head.add(button, "wmin 0");
        }
        next.addActionListener(event -> goOn());
        Keys.bindEnter(next, next::doClick);
        Keys.bindEnter(pageRoom, this::goOnByKey);
        Keys.bindEnter(sliderRoom, this::goOnByKey);
        head.add(next);
        foot.add(progress, "wmin 0");
        foot.add(again);
        // always here, even while there is no lesson: what is added later would not have taken part in a change of look
        for (JComponent part : List.of(head, problem.component(), pageRoom, sliderRoom, foot, remarks.component())) {
            panel.add(part, "wmin 0, gapbottom 4");
        }
        make();
        model.follow(this::update);
        course.follow(() -> {
            if (lesson != null) {
                updateNext();
            }
        });
    }

    private void goOnByKey() {
        if (next.isEnabled()) {
            next.doClick();
        }
        if (next.isEnabled()) {
            // the page with the keys is hidden now; a request before that could be lost
            next.requestFocusInWindow();
        }
    }

    /** Begins the lesson of the model's studio with its first page; false if it has none. */
    public boolean begin() {
        shown = NoLesson.DEFAULT;
        update();
        return shown instanceof Lesson;
    }

    /** What takes the keys when the lesson begins: its first prediction. */
    public JComponent entry() {
        return lesson == null ? again : question.entry();
    }

    private void update() {
        if (measured != null && !model.studio().equals(measured)) {
            measured = null;
            stage.mark(List.of());
        }
        LessonPlan plan = model.studio().lesson();
        if (!Descriptions.areEqual(plan, shown)) {
            shown = plan;
            make();
        } else if (lesson != null) {
            showSlider();
            updateNext();
        }
    }

    private void make() {
        lesson = null;
        pages.clear();
        pageRoom.removeAll();
        sliderRoom.removeAll();
        problem.setText("");
        panel.setVisible(shown instanceof Lesson);
        remarks.setText(FactText.readable(model.studio().remarks()));
        if (shown instanceof Lesson) {
            try {
                lesson = LessonStudio.of(model.studio()).orElseThrow();
                addPages(lesson.lesson());
                farthest = Step.PREDICT;
                flown = false;
                show(Step.PREDICT);
            } catch (InvalidPropertyException wrong) {
                problem.setError(Texts.get("lesson.unusable", wrong.getMessage()));
            }
        }
        List.of(head, sliderRoom, foot).forEach(part -> part.setVisible(lesson != null));
        if (lesson != null) {
            showSlider();
        }
        panel.revalidate();
        panel.repaint();
    }

    private void addPages(Lesson fitting) {
        question = new LessonQuestionPage(fitting, this::updateNext);
        slider = new LessonSlider(model, lesson);
        boolean rides = !model.opened().ride().isEmpty();
        look = new LessonLookPage(rides ? this::fly : null);
        reason = new LessonReasonPage(
                fitting,
                model.studio().scene().isEmpty(),
                stage::showOutlines,
                this::setSlider,
                rides ? this::showDiagram : null);
        numbers = new LessonNumbersPage(fitting);
        pages.put(Step.PREDICT, question);
        pages.put(Step.LOOK, look);
        pages.put(Step.REASON, reason);
        pages.put(Step.MEASURE, numbers);
        pages.values().forEach(page -> pageRoom.add(page.component(), "wmin 0"));
        sliderRoom.add(slider.component(), "wmin 0");
    }

    /**
     * The slider stays from the second page on, but for what is measured, and while a ride has its number beyond the
     * ends.
     */
    private void showSlider() {
        slider.update();
        look.update(slider.isThere());
        sliderRoom.setVisible(farthest != Step.PREDICT && step != Step.MEASURE && slider.isReached());
    }

    private void setSlider(double value) {
        fitting().ifPresent(present -> model.set(present.number().with(present.studio(), value)));
    }

    /** Flies the ride of the scene, from its beginning. */
    private void fly() {
        flown = true;
        model.set(LessonStudio.unmoved(model.atHome(), model.opened()));
        updateNext();
        stage.fly();
    }

    /** Shows the ride of the scene in space and time. */
    private void showDiagram() {
        diagram.show(SpaceTimeDiagram.ofRide(model.opened()), Texts.get("ray.diagram.ride"));
        diagram.open(panel);
    }

    private void show(Step other) {
        step = other;
        stage.mark(List.of());
        stage.showOutlines(false);
        pages.forEach((each, page) -> page.component().setVisible(each == step));
        if (step.compareTo(farthest) > 0) {
            farthest = step;
            question.close();
        }
        steps.forEach((each, button) -> {
            button.setSelected(each == step);
            button.setEnabled(each.compareTo(farthest) <= 0);
            button.putClientProperty(FlatClientProperties.STYLE, each == step ? "font: bold" : "");
        });
        showSlider();
        updateNext();
    }

    private void finishIf(boolean done) {
        if (done) {
            course.finish(model.studio());
            updateNext();
        }
    }

    private void updateNext() {
        String key = "lesson.next." + following().map(Step::name).orElse("LESSON");
        Naming.name(next, key);
        next.setText(Texts.get(key));
        next.setVisible(following().isPresent() || course.after(model.studio()).isPresent());
        boolean looked = step != Step.LOOK || farthest != Step.LOOK || slider.isMoved() || flown;
        next.setEnabled(question.answer().isPresent() && looked);
        progress.setText(course.progress(model.studio()));
    }

    /** The next page; none after the last, which measures if the lesson has numbers. */
    private Optional<Step> following() {
        return switch (step) {
            case PREDICT -> Optional.of(Step.LOOK);
            case LOOK -> Optional.of(Step.REASON);
            case REASON -> lesson.lesson().numbers().isEmpty() ? Optional.empty() : Optional.of(Step.MEASURE);
            case MEASURE -> Optional.empty();
        };
    }

    /** Goes to a page that was chosen; the page that is shown is marked as chosen, too. */
    private void choose(Step chosen) {
        if (chosen != step) {
            goTo(chosen);
        }
    }

    private void goOn() {
        following().ifPresentOrElse(this::goTo, () -> course.openAfter(model.studio()));
    }

    private void goTo(Step chosen) {
        question.answer().ifPresent(answer -> {
            look.show(answer);
            reason.show(answer);
        });
        show(chosen);
        LessonStudio.otherShutter(lesson.lesson()).ifPresent(stage::compare);
        if (!next.isEnabled()) {
            // after a tap it gets the keys only now, and would hold them without using them
            slider.takeKeys();
        }
        if (chosen == Step.REASON) {
            reason.showFirst();
            // the text explains what must be on the screen
            fitting().ifPresent(present -> {
                model.set(present.measured());
                finishIf(following().isEmpty());
            });
        } else if (chosen == Step.MEASURE) {
            fitting().ifPresent(this::measure);
        }
    }

    /**
     * The lesson with the studio as it is now, but for a camera that was turned or ridden away, which stands where the
     * lesson has it; says what is wrong if they do not fit each other any more.
     */
    private Optional<LessonStudio> fitting() {
        try {
            return LessonStudio.of(isWhereItBegan() ? model.studio() : model.atHome());
        } catch (InvalidPropertyException lost) {
            numbers.showProblem(lost.getMessage());
            return Optional.empty();
        }
    }

    private boolean isWhereItBegan() {
        Studio unmoved = model.unmoved();
        Shutter shutter = unmoved.camera().shutter();
        return model.isAtHome(unmoved)
                && (!shutter.hasOpeningTime()
                        || shutter.equals(model.opened().camera().shutter()));
    }

    private void startAgain() {
        model.reset();
        begin();
    }

    /** Measures with a studio in which the lesson has moved its number. */
    private void measure(LessonStudio present) {
        numbers.showBusy();
        model.set(present.measured());
        measured = model.studio();
        LessonNumbersPage page = numbers;
        BackgroundTask.find(
                SwingUtilities.getWindowAncestor(panel),
                Texts.get("lesson.measuring"),
                () -> afterMeasuring(present, page),
                Runnable::run);
    }

    /** Measures, and returns what has to be done afterwards. */
    private Runnable afterMeasuring(LessonStudio present, LessonNumbersPage page) {
        try {
            List<LessonResult> results = present.results();
            return () -> {
                page.show(results);
                if (model.studio().equals(measured)) {
                    stage.mark(results);
                    finishIf(results.stream().allMatch(LessonResult::agrees));
                }
            };
        } catch (InvalidPropertyException impossible) {
            return () -> page.showProblem(impossible.getMessage());
        }
    }
}
