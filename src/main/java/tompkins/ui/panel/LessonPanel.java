package tompkins.ui.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Window;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import tompkins.experiment.LessonResult;
import tompkins.experiment.LessonStudio;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonPlan;
import tompkins.lesson.NoLesson;
import tompkins.property.InvalidPropertyException;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.CardPanel;
import tompkins.ui.widget.ChoiceRow;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Texts;

/** The strip of a lesson under the picture. It leads from page to page: predict, look, learn why, measure. */
public final class LessonPanel {

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
    private final JPanel panel = new Strip();
    private final JPanel head = new JPanel(new MigLayout("novisualpadding, insets 0, fillx, gap 2 0"));

    private final Map<Step, JToggleButton> steps = new EnumMap<>(Step.class);
    private final JButton again = new JButton(Texts.get("lesson.again"));
    private final JButton next = new JButton();
    private final Note problem = new Note("");

    /** What the strip was made for. */
    private LessonPlan shown = NoLesson.DEFAULT;

    private LessonStudio lesson;
    private Step step = Step.PREDICT;

    /** The last page that was seen: from there one can go back, and forward again. */
    private Step farthest = Step.PREDICT;

    private CardPanel cards;
    private LessonQuestionPage question;
    private LessonLookPage look;
    private LessonReasonPage reason;
    private LessonNumbersPage numbers;

    /** The strip, invisible as long as the studio of the model has no lesson. */
    public LessonPanel(StudioModel model) {
        this.model = model;
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
        Naming.name(again, "lesson.again");
        again.addActionListener(event -> startAgain());
        next.addActionListener(event -> goOn());
        // always here, even while there is no lesson: what is added later would not have taken part in a change of look
        panel.add(head, "growx, wmin 0, wrap");
        panel.add(problem.component(), "growx, wmin 0, wrap");
        fillHead();
        model.addListener(this::update);
        update();
    }

    /** The strip itself. */
    public JComponent component() {
        return panel;
    }

    /** Begins the lesson of the model's studio with its first page; false if it has none. */
    public boolean begin() {
        shown = NoLesson.DEFAULT;
        update();
        return shown instanceof Lesson;
    }

    private void update() {
        LessonPlan plan = model.studio().lesson();
        if (!plan.equals(shown)) {
            shown = plan;
            make();
        } else if (lesson != null) {
            look.update();
        }
    }

    private void fillHead() {
        head.setOpaque(false);
        for (JToggleButton button : steps.values()) {
            head.add(button, "wmin 0");
        }
        head.add(again, "pushx, alignx right");
        head.add(next);
    }

    private void make() {
        if (cards != null) {
            panel.remove(cards.component());
            cards = null;
        }
        lesson = null;
        problem.setText("");
        panel.setVisible(shown instanceof Lesson);
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
        look = new LessonLookPage(model, lesson);
        reason = new LessonReasonPage(fitting);
        numbers = new LessonNumbersPage();
        cards = new CardPanel();
        cards.add(LessonQuestionPage.class, question.component());
        cards.add(LessonLookPage.class, look.component());
        cards.add(LessonReasonPage.class, reason.component());
        cards.add(LessonNumbersPage.class, numbers.component());
        panel.add(cards.component(), "growx, wmin 0");
    }

    private void show(Step other) {
        step = other;
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
        updateNext();
    }

    private void updateNext() {
        Optional<Step> following = following();
        next.setVisible(following.isPresent());
        following.ifPresent(coming -> {
            Naming.name(next, "lesson.next." + coming);
            next.setText(Texts.get("lesson.next." + coming));
        });
        next.setEnabled(question.answer().isPresent());
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
        following().ifPresent(this::goTo);
    }

    private void goTo(Step following) {
        question.answer().ifPresent(answer -> {
            look.show(answer);
            reason.show(answer);
        });
        show(following);
        if (following == Step.REASON) {
            // the text explains what must be on the screen
            fitting().ifPresent(present -> model.set(present.measured()));
        } else if (following == Step.MEASURE) {
            fitting().ifPresent(this::measure);
        }
    }

    /** The lesson with the studio as it is now; says what is wrong if they do not fit each other any more. */
    private Optional<LessonStudio> fitting() {
        try {
            return LessonStudio.of(model.studio());
        } catch (InvalidPropertyException lost) {
            numbers.showProblem(lost.getMessage());
            return Optional.empty();
        }
    }

    private void startAgain() {
        model.reset();
        begin();
    }

    /** Measures with a studio as it is, except for the number that the lesson moves. */
    private void measure(LessonStudio present) {
        numbers.showBusy();
        model.set(present.measured());
        Window window = SwingUtilities.getWindowAncestor(panel);
        LessonNumbersPage page = numbers;
        BackgroundTask.find(window, Texts.get("lesson.measuring"), () -> Outcome.of(present), found -> {
            if (found.problem == null) {
                page.show(found.results);
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

    /** A panel with a line above it, in any look. */
    private static final class Strip extends JPanel {

        private static final long serialVersionUID = 1;

        Strip() {
            super(new MigLayout("novisualpadding, insets 6 10 6 10, fillx, hidemode 3, gap 6 6"));
        }

        @Override
        public void updateUI() {
            super.updateUI();
            setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, UIManager.getColor("Tompkins.line")));
        }
    }
}
