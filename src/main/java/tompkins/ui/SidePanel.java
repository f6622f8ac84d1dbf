package tompkins.ui;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Dimension;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import tompkins.lesson.Lesson;
import tompkins.studio.StudioPath;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.editor.SceneEditor;
import tompkins.ui.model.StudioModel;
import tompkins.ui.panel.ControlRows;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Picture;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.ray.RaySection;
import tompkins.ui.widget.Column;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/**
 * The panel beside the photograph, with two tabs: the few controls of a class, or the lesson, and the form with all
 * controls. A pinned ray has a place below.
 */
final class SidePanel {

    /** Widths in sizes of the type: of the few controls, of a lesson, and of the form. */
    private static final double FEW = 21;

    private static final double LESSON = 26;
    static final double FORM = 29;

    /** Where the place of the pinned ray begins, as a fraction of the height. */
    private static final double RAY_BEGINS = 0.45;

    private final StudioModel model;
    private final Runnable turned;
    private final JPanel room = new Room();
    private final JPanel head = Rows.of("gap 4, insets 4 6 0 6", "[grow,fill][grow,fill][grow,fill]");
    private final JToggleButton all = new JToggleButton(Texts.get("panel.all"));
    private final Column panel = new Column();
    private final JScrollPane scroll = panel.scrolled("panel");
    private final JPanel tab = new JPanel(new CardLayout());
    private final JPanel controls = Rows.column();
    private final Column rayPanel = new Column();

    /** The pinned ray has a place of its own, so that the speed stays visible. */
    private final JScrollPane rayScroll = rayPanel.scrolled("ray");

    private final JSplitPane split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, tab, rayScroll);
    final ComparePanel compare;
    private final Note title = new Note("");
    private final Note remarks = new Note("");
    private final Note warnings = new Note("");
    private final Note sentences = new Note("");
    private final RaySection ray;

    /** The form with all controls; null until it is first wanted. */
    private SceneEditor editor;

    /**
     * The panel for a photograph.
     *
     * @param lesson the lesson of the scene, invisible without one
     * @param actions what stands above both tabs, beside the button that turns to the other one
     * @param turned notified when the other tab is shown
     */
    SidePanel(StudioModel model, PhotographView view, JComponent lesson, List<JButton> actions, Runnable turned) {
        this.model = model;
        this.turned = turned;
        compare = new ComparePanel(model, view::compare, view::keepPicture);
        ray = new RaySection(model, () -> view.setPin(null), view::askCone, this::edit);
        for (AbstractButton button :
                Stream.concat(actions.stream(), Stream.of(all)).toList()) {
            button.putClientProperty(FlatClientProperties.STYLE, "margin: 2,4,2,4; minimumWidth: 0");
            head.add(button);
        }
        Naming.name(all, "panel.all");
        all.addItemListener(event -> turn());
        title.component().setName("remarks.title");
        remarks.component().setName("remarks");
        panel.add(title.component(), "wmin 0, gapbottom 4");
        panel.add(lesson, "wmin 0, gapbottom 4");
        controls.add(compare.component(), "wmin 0");
        controls.add(remarks.component(), "wmin 0");
        controls.add(warnings.component(), "wmin 0");
        controls.add(sentences.component(), "wmin 0");
        panel.add(controls, "wmin 0");
        tab.add(scroll, "few");
        room.add(head, BorderLayout.NORTH);
        room.add(split, BorderLayout.CENTER);
        rayPanel.add(ray.component());
        rayScroll.setVisible(false);
        split.setBorder(BorderFactory.createEmptyBorder());
        split.setDividerSize(0);
        split.getAccessibleContext().setAccessibleName(Texts.get("panel.split"));
        split.setResizeWeight(RAY_BEGINS);
        Keys.freeForWindow(split);
        model.follow(this::update);
    }

    /** Adds the rows with the controls. */
    void addRows() {
        controls.add(new ControlRows(model).component(), "wmin 0", 0);
        room.revalidate();
    }

    /** In a lesson its page takes the place of the controls. */
    private void update() {
        boolean ofLesson = isLesson();
        title.setText(ofLesson ? "" : model.studio().shortTitle());
        // a lesson has them in full
        String text = ofLesson ? "" : model.studio().remarks();
        if (!remarks.text().equals(text)) {
            remarks.setText(text);
            SwingUtilities.invokeLater(() -> scroll.getVerticalScrollBar().setValue(0));
        }
        if (controls.isVisible() == ofLesson) {
            controls.setVisible(!ofLesson);
            room.revalidate();
        }
    }

    private boolean isLesson() {
        return model.studio().lesson() instanceof Lesson;
    }

    /** Shows the tab that is chosen. */
    private void turn() {
        if (editor == null) {
            editor = new SceneEditor(model);
            tab.add(editor.component(), "all");
        }
        ((CardLayout) tab.getLayout()).show(tab, all.isSelected() ? "all" : "few");
        room.revalidate();
        turned.run();
    }

    /** Shows all controls, or the few. */
    void setEditing(boolean editing) {
        setShown(room.isVisible() || editing);
        all.setSelected(editing);
    }

    /** Whether all controls are on the screen. */
    boolean isEditing() {
        return all.isSelected() && room.isVisible();
    }

    /** Shows the form of a part of the studio, unless a wrong value must be corrected first. */
    void edit(StudioPath part) {
        setEditing(true);
        editor.choose(part);
    }

    /** Shows the panel, or hides it. */
    void setShown(boolean shown) {
        room.setVisible(shown);
    }

    JComponent component() {
        return room;
    }

    /** Shows the messages about the picture on the screen: what it models and leaves out, and what went wrong. */
    void show(Picture picture) {
        String wrong = String.join("\n\u26A0 ", picture.warnings());
        if (wrong.isEmpty()) {
            warnings.setText("");
        } else {
            warnings.setError(wrong);
        }
        sentences.setText(String.join("\n\n", picture.sentences()));
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

    /** As wide as what it shows needs, in any look. */
    @SuppressWarnings("serial") // never written to a stream
    private final class Room extends JPanel {

        Room() {
            super(new BorderLayout());
        }

        @Override
        public void updateUI() {
            super.updateUI();
            setBorder(BorderFactory.createMatteBorder(0, 1, 0, 0, UIManager.getColor("Tompkins.line")));
        }

        @Override
        public Dimension getPreferredSize() {
            double sizes = all.isSelected() ? FORM : isLesson() ? LESSON : FEW;
            int texts =
                    panel.getMinimumSize().width + scroll.getVerticalScrollBar().getPreferredSize().width;
            int least = Math.max(texts, head.getMinimumSize().width) + 1;
            return new Dimension(Math.max(Look.pixels(sizes), least), 0);
        }
    }
}
