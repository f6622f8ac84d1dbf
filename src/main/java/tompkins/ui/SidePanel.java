package tompkins.ui;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import tompkins.camera.Camera;
import tompkins.camera.FocusDistance;
import tompkins.lesson.Lesson;
import tompkins.property.NumberText;
import tompkins.shutter.Shutter;
import tompkins.studio.StudioPath;
import tompkins.trace.RenderPlan;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.model.StudioModel;
import tompkins.ui.panel.CameraPanel;
import tompkins.ui.panel.LawPanel;
import tompkins.ui.panel.LensPanel;
import tompkins.ui.panel.QualityPanel;
import tompkins.ui.panel.ShutterPanel;
import tompkins.ui.panel.StereoPanel;
import tompkins.ui.panel.VelocityPanel;
import tompkins.ui.panel.WindowPanel;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Picture;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.ray.RaySection;
import tompkins.ui.widget.Column;
import tompkins.ui.widget.FoldedText;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Section;
import tompkins.ui.widget.Texts;

/** The narrow panel beside the photograph: everything that a teacher adjusts, one part under the other. */
final class SidePanel {

    private static final double WIDTH = 25;

    /** Its width on a projector. */
    private static final double SLIM = 18;

    /** That of a lesson there. */
    private static final double LESSON = 25;

    /** Where the place of the pinned ray begins, as a share of the height. */
    private static final double RAY_BEGINS = 0.45;

    private final JPanel panel = new Column();
    private final JScrollPane scroll = scroll("panel", panel);
    private final Column rayPanel = new Column();

    /** The pinned ray has a place of its own, so that the speed stays visible. */
    private final JScrollPane rayScroll = scroll("ray", rayPanel);

    private final JSplitPane split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, scroll, rayScroll);
    private final VelocityPanel velocity;
    private final JPanel quickColours;
    private final ShutterPanel shutter;
    private final LensPanel lens;
    private final ComparePanel compare;
    private final Note title = Note.ofLines(1);
    private final Note warnings = new Note("");
    private final Note sentences = new Note("");
    private final RaySection ray;
    private final FoldedText remarks = new FoldedText("remarks");
    private final List<JComponent> sections = new ArrayList<>();

    /** Brings back what a lesson, or a projector, leaves out. */
    private final JToggleButton all = new JToggleButton();

    private final StudioModel model;
    private final JComponent speed;
    private final JComponent shutters;
    private Runnable whenWidthChanges = () -> {};

    /** The least width of what is shown, in sizes of the type. */
    private double sizes = WIDTH;

    private Picture shown;

    /**
     * The panel for a photograph.
     *
     * @param lesson the lesson of the scene, invisible without one
     * @param besideRest whether the photograph is compared with that of a camera at rest from the beginning
     * @param teller says in a line what becomes of a click
     * @param editor opens the editor for a part of the studio
     */
    SidePanel(
            StudioModel model,
            PhotographView view,
            JComponent lesson,
            boolean besideRest,
            Consumer<String> teller,
            Consumer<StudioPath> editor) {
        this.model = model;
        velocity = new VelocityPanel(model);
        quickColours = LawPanel.quickColours(model);
        shutter = new ShutterPanel(model);
        lens = new LensPanel(model, picking -> pick(model, view, teller, picking));
        compare = new ComparePanel(model, view::compare, view.canvas()::setOtherAlone, view::keepPicture);
        if (besideRest) {
            compare.begin(ComparePanel.Other.AT_REST);
        }
        ray = new RaySection(model, () -> view.setPin(null), view::askCone, editor);
        title.component().setName("remarks.title");
        JPanel head = Rows.of("hidemode 3, gap 6", "[grow,fill][pref!]");
        head.add(title.component(), "wmin 0");
        head.add(remarks.button());
        panel.add(head, "wmin 0, gapleft 6");
        panel.add(remarks.component(), "wmin 0, gapleft 6, gapbottom 4");
        panel.add(lesson, "wmin 0, gapleft 6, gapbottom 4");
        speed = add("section.velocity", below(velocity.component(), quickColours, 0), true);
        add(
                "section.camera",
                below(new CameraPanel(model, () -> shown).component(), new StereoPanel(model).component(), 8),
                false);
        shutters = add("section.shutter", shutter.component(), true);
        add("section.shutterDetails", shutter.details(), false);
        add("section.lens", lens.component(), false);
        add("section.compare", compare.component(), besideRest);
        add(
                "section.transformation",
                below(
                        LawPanel.ofTransformation(model).component(),
                        LawPanel.ofView(model).component(),
                        8),
                false);
        add("section.colours", LawPanel.ofColours(model).component(), false);
        add("section.window", new WindowPanel(model).component(), false);
        add("section.quality", new QualityPanel(model).component(), false);
        add("section.plan", below(warnings.component(), sentences.component(), 0), false);
        Naming.name(all, "panel.all");
        all.addActionListener(event -> showSections());
        panel.add(all, "growx 0, gapleft 6, gapright push, gaptop 6");
        Runnable update = () -> {
            show(model);
            showSections();
        };
        model.follow(update);
        rayPanel.add(ray.component());
        rayScroll.setVisible(false);
        split.setBorder(BorderFactory.createEmptyBorder());
        split.setDividerSize(0);
        split.getAccessibleContext().setAccessibleName(Texts.get("panel.split"));
        split.setResizeWeight(RAY_BEGINS);
        // keys of the window, for which split panes have a use of their own
        for (String key : List.of("F6", "F8")) {
            split.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(key), "none");
        }
    }

    /** Two choices of one section, told apart by a gap of some pixels. */
    private static JComponent below(JComponent first, JComponent second, int gap) {
        JPanel both = Rows.column();
        both.add(first, "wmin 0");
        both.add(second, "wmin 0, gaptop " + gap);
        return both;
    }

    private static JScrollPane scroll(String name, JComponent content) {
        JScrollPane scroll = new JScrollPane(
                content,
                // so that nothing moves sideways when there is more, or less, than fits
                ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setName(name);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        // beside the other one it takes the room that is left
        scroll.setMinimumSize(new Dimension(0, 0));
        scroll.getVerticalScrollBar().setUnitIncrement(20);
        return scroll;
    }

    /** Scrolls to what there is to see in another scene. */
    private void show(StudioModel model) {
        // a lesson has them in full
        String text =
                model.studio().lesson() instanceof Lesson ? "" : model.studio().remarks();
        title.setText(titled(model, model.studio().shortTitle()));
        if (!remarks.text().equals(text)) {
            remarks.setText(text);
            SwingUtilities.invokeLater(() -> scroll.getVerticalScrollBar().setValue(0));
        }
    }

    /** A title of the scene, which says so if it is that of a changed example. */
    static String titled(StudioModel model, String title) {
        return model.isChangedExample() ? Texts.get("title.changed", title) : title;
    }

    private JComponent add(String title, JComponent content, boolean open) {
        JComponent section = new Section(Texts.get(title), content, open).component();
        sections.add(section);
        panel.add(section);
        return section;
    }

    /** In a lesson the controls of its subject, on a projector speed, colours and opening time; else all. */
    private void showSections() {
        boolean ofLesson = model.studio().lesson() instanceof Lesson;
        boolean few = !all.isSelected() && (ofLesson || Look.isSlim());
        boolean brief = few && !ofLesson;
        sections.forEach(section -> section.setVisible(!few));
        speed.setVisible(!few || brief);
        velocity.setBrief(brief);
        // a slim panel has room for two of three side by side
        ((MigLayout) quickColours.getLayout())
                .setComponentConstraints(quickColours.getComponent(1), brief ? "wmin 0, wrap" : "wmin 0");
        shutters.setVisible(!few || brief);
        shutter.setBrief(brief);
        all.setVisible(ofLesson || Look.isSlim());
        all.setText(Texts.get(all.isSelected() ? "panel.few" : "panel.all"));
        double before = sizes;
        sizes = !few || !Look.isSlim() ? WIDTH : ofLesson ? LESSON : SLIM;
        if (sizes != before) {
            whenWidthChanges.run();
        }
    }

    /** Shows what belongs to the look, in the room that it needs. */
    void fitToLook() {
        showSections();
        whenWidthChanges.run();
    }

    /** Tells from now on that {@link #width} may be another. */
    void setWhenWidthChanges(Runnable listener) {
        whenWidthChanges = listener;
    }

    private void pick(StudioModel model, PhotographView view, Consumer<String> teller, boolean picking) {
        if (picking) {
            view.startPicking(distance -> focus(model, teller, distance), lens::endPicking);
        } else {
            view.stopPicking();
        }
    }

    /** Focuses at a distance; false if a click that met no object gave none, so that the user can try again. */
    private static boolean focus(StudioModel model, Consumer<String> teller, double distance) {
        if (distance > 0) {
            Camera camera = model.studio().camera();
            model.set(model.studio().withCamera(FocusDistance.with(camera, NumberText.rounded(distance, 6))));
        } else {
            teller.accept(Texts.get("lens.pickedNothing"));
        }
        return distance > 0;
    }

    /** Shows what another shutter sees beside the picture. */
    void compare(Class<? extends Shutter> other) {
        compare.compareShutter(other);
    }

    /** Shows the picture alone: a ride begins so. */
    void unsplit() {
        compare.choose(ComparePanel.Other.NOTHING);
    }

    /** The least width of the panel. */
    static int leastWidth() {
        return Look.pixels(Look.isSlim() ? SLIM : WIDTH);
    }

    /** The width that it needs: that of its texts, at least that of a narrow panel, or of a slim one. */
    int width() {
        int texts = panel.getMinimumSize().width + scroll.getVerticalScrollBar().getPreferredSize().width;
        return Math.max(Look.pixels(sizes), texts);
    }

    JComponent component() {
        return split;
    }

    /** Shows the messages about the picture on the screen. */
    void show(Picture picture) {
        RenderPlan made = picture.plan();
        if (shown == null || shown.plan() != made || !shown.warnings().equals(picture.warnings())) {
            tell(picture.sentences(), picture.warnings());
            shutter.showPlace(made.lensInScene());
            lens.show(picture);
        }
        shown = picture;
    }

    /** Says what the picture models and what it leaves out, and before that what went wrong. */
    private void tell(List<String> models, List<String> wrong) {
        if (wrong.isEmpty()) {
            warnings.setText("");
        } else {
            warnings.setError(String.join("\n\u26A0 ", wrong));
        }
        sentences.setText(String.join("\n\n", models));
    }

    /** Shows the life of the pinned ray, or nothing if it is null; of the picture with a name, or of the studio's. */
    void show(PixelReading pinned, String picture) {
        ray.show(pinned, picture);
        boolean isPinned = pinned != null;
        if (rayScroll.isVisible() != isPinned) {
            rayScroll.setVisible(isPinned);
            split.setDividerSize(isPinned ? UIManager.getInt("SplitPane.dividerSize") : 0);
            if (isPinned) {
                split.setDividerLocation(RAY_BEGINS);
            }
            split.revalidate();
        }
    }
}
