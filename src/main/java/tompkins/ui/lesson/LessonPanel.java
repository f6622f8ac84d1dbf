package tompkins.ui.lesson;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Window;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
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
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.CardPanel;
import tompkins.ui.widget.ChoiceRow;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The strip of a lesson under the picture. It leads from page to page: predict, look, learn why, measure. */
public final class LessonPanel extends Part {

    /** The pages, in their order. */
    private enum Step {
        PREDICT(LessonQuestionPage.class),
        LOOK(LessonLookPage.class),
        REASON(LessonReasonPage.class),
        MEASURE(LessonNumbersPage.class);

        private final Class<?> page;

        Step(Class<?> page) {
            this.page = page;
        }
    }

    private final StudioModel model;
    private final LessonCourse course;
    private final Consumer<List<LessonResult>> drawer;
    private final JPanel head = new JPanel(new MigLayout("novisualpadding, insets 0, fillx, gap 2 0"));

    private final JPanel stepRow = Rows.of("gap 2", "[]".repeat(Step.values().length));
    private final JPanel buttonRow = Rows.of("hidemode 3, gap 6", "[][][]");
    private final Map<Step, JToggleButton> steps = new EnumMap<>(Step.class);
    private final JButton again = Buttons.of("lesson.again", this::startAgain);
    private final JButton next = new JButton();
    private final JLabel progress = new JLabel();
    private final Note problem = new Note("");

    /** Holds a slider of the lesson that stays while its pages change. */
    private final JPanel control = Rows.column();

    /** Whether it is to be seen where there is a lesson. */
    private boolean wanted = true;

    /** What is drawn into the picture while the lesson is shown. */
    private List<LessonResult> drawn = List.of();

    /** What the strip was made for. */
    private LessonPlan shown = NoLesson.DEFAULT;

    private LessonStudio lesson;

    /** The studio in which was measured, until another one is there; null before. */
    private Studio measured;

    private Step step = Step.PREDICT;

    /** The last page that was seen: from there one can go back, and forward again. */
    private Step farthest = Step.PREDICT;

    private CardPanel cards;
    private LessonQuestionPage question;
    private LessonLookPage look;
    private LessonSlider slider;
    private LessonSlider lastingSlider;
    private LessonReasonPage reason;
    private LessonNumbersPage numbers;

    /**
     * The strip, invisible as long as the studio of the model has no lesson.
     *
     * @param drawer draws into the picture where something was measured
     */
    public LessonPanel(StudioModel model, LessonCourse course, Consumer<List<LessonResult>> drawer) {
        super(new JPanel(new MigLayout("novisualpadding, insets 0 4 0 4, fillx, hidemode 3, gap 6 6")));
        this.model = model;
        this.course = course;
        this.drawer = drawer;
        panel.setVisible(false);
        ButtonGroup group = new ButtonGroup();
        for (Step each : Step.values()) {
            JToggleButton button = new JToggleButton(Texts.get("lesson.step." + each));
            Naming.name(button, "lesson.step." + each);
            button.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
            ChoiceRow.whenChosen(button, () -> choose(each));
            group.add(button);
            steps.put(each, button);
        }
        next.addActionListener(event -> goOn());
        Keys.bindEnter(next, next::doClick);
        // always here, even while there is no lesson: what is added later would not have taken part in a change of look
        panel.add(head, "growx, wmin 0, wrap");
        panel.add(problem.component(), "growx, wmin 0, wrap");
        fillHead();
        model.follow(this::update);
        course.follow(() -> {
            if (lesson != null) {
                updateNext();
            }
        });
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

    /** Shows the lesson, or hides it. */
    public void setShown(boolean now) {
        wanted = now;
        draw(drawn);
        panel.setVisible(wanted && shown instanceof Lesson);
    }

    private void draw(List<LessonResult> results) {
        drawn = results;
        drawer.accept(wanted ? results : List.of());
    }

    private void update() {
        if (measured != null && !model.studio().equals(measured)) {
            measured = null;
            draw(List.of());
        }
        LessonPlan plan = model.studio().lesson();
        if (!Descriptions.areEqual(plan, shown)) {
            shown = plan;
            make();
        } else if (lesson != null) {
            slider.update();
            lastingSlider.update();
            look.update(slider.isThere());
            updateNext();
        }
    }

    private void fillHead() {
        head.setOpaque(false);
        steps.values().forEach(button -> stepRow.add(button, "wmin 0"));
        buttonRow.add(progress, "wmin 0");
        buttonRow.add(again);
        buttonRow.add(next);
        head.add(stepRow, "pushx");
        head.add(buttonRow, "alignx right");
        head.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                arrangeHead();
            }
        });
    }

    /** Gives the buttons a line of their own where one line has no room for all. */
    private void arrangeHead() {
        boolean fits = stepRow.getPreferredSize().width + buttonRow.getPreferredSize().width < head.getWidth();
        ((MigLayout) head.getLayout())
                .setComponentConstraints(buttonRow, fits ? "alignx right" : "newline, alignx right");
        head.revalidate();
    }

    private void make() {
        if (cards != null) {
            panel.remove(cards.component());
            cards = null;
        }
        lesson = null;
        control.removeAll();
        control.setVisible(false);
        control.revalidate();
        problem.setText("");
        setShown(wanted);
        if (shown instanceof Lesson) {
            try {
                lesson = LessonStudio.of(model.studio()).orElseThrow();
                addPages(lesson.lesson());
                farthest = Step.PREDICT;
                show(Step.PREDICT);
            } catch (InvalidPropertyException wrong) {
                problem.setError(Texts.get("lesson.unusable", wrong.getMessage()));
            }
        }
        head.setVisible(lesson != null);
        panel.revalidate();
        panel.repaint();
    }

    private void addPages(Lesson fitting) {
        question = new LessonQuestionPage(fitting, this::updateNext);
        slider = new LessonSlider(model, lesson);
        lastingSlider = new LessonSlider(model, lesson);
        control.add(lastingSlider.component(), "wmin 0");
        look = new LessonLookPage(slider);
        reason = new LessonReasonPage(fitting);
        numbers = new LessonNumbersPage();
        cards = new CardPanel();
        Keys.bindEnter(cards.component(), () -> {
            if (next.isEnabled()) {
                next.doClick();
            }
            if (next.isEnabled()) {
                // the page with the keys is hidden now; a request before that could be lost
                next.requestFocusInWindow();
            }
        });
        cards.add(LessonQuestionPage.class, question.component());
        cards.add(LessonLookPage.class, look.component());
        cards.add(LessonReasonPage.class, reason.component());
        cards.add(LessonNumbersPage.class, numbers.component());
        panel.add(cards.component(), "growx, wmin 0");
    }

    private void show(Step other) {
        step = other;
        draw(List.of());
        cards.show(step.page);
        if (step.compareTo(farthest) > 0) {
            farthest = step;
            question.close();
        }
        steps.forEach((each, button) -> {
            button.setSelected(each == step);
            button.setEnabled(each.compareTo(farthest) <= 0);
            button.putClientProperty(FlatClientProperties.STYLE, each == step ? "font: bold" : "");
        });
        // before the prediction it would show the answer
        control.setVisible(farthest != Step.PREDICT);
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
        next.setVisible(hasNextPage() || course.goesOnAfter(model.studio()));
        boolean looked = step != Step.LOOK || farthest != Step.LOOK || slider.isMoved();
        next.setEnabled(question.answer().isPresent() && looked);
        progress.setText(course.progress(model.studio()));
        arrangeHead();
    }

    private boolean hasNextPage() {
        return following().isPresent();
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

    /** A slider of the lesson for another part of the window; seen from the prediction on. */
    public JComponent control() {
        return control;
    }

    private void goTo(Step following) {
        question.answer().ifPresent(answer -> {
            look.show(answer);
            reason.show(answer);
        });
        show(following);
        if (!next.isEnabled()) {
            // after a tap it gets the keys only now, and would hold them without using them
            slider.takeKeys();
        }
        if (following == Step.REASON) {
            // the text explains what must be on the screen
            fitting().ifPresent(present -> {
                model.set(present.measured());
                finishIf(!hasNextPage());
            });
        } else if (following == Step.MEASURE) {
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
        Studio unmoved = LessonStudio.unmoved(model.studio(), model.opened());
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
        Window window = SwingUtilities.getWindowAncestor(panel);
        LessonNumbersPage page = numbers;
        BackgroundTask.find(window, Texts.get("lesson.measuring"), () -> Outcome.of(present), found -> {
            if (found.problem == null) {
                page.show(found.results);
                if (model.studio().equals(measured)) {
                    draw(found.results);
                    finishIf(found.results.stream().allMatch(LessonResult::agrees));
                }
            } else {
                page.showProblem(found.problem);
            }
        });
    }

    /**
     * The result of measuring.
     *
     * @param results what was measured
     * @param problem why nothing was measured, or null
     */
    private record Outcome(List<LessonResult> results, String problem) {

        static Outcome of(LessonStudio lesson) {
            try {
                return new Outcome(lesson.results(), null);
            } catch (InvalidPropertyException impossible) {
                return new Outcome(List.of(), impossible.getMessage());
            }
        }
    }
}
