package tompkins.ui.compare;

import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import tompkins.lesson.Lesson;
import tompkins.property.Descriptions;
import tompkins.shutter.Shutter;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Comparison;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.Wording;

/** What the picture is compared with, and how the two are shown. */
public final class ComparePanel extends Part {

    /** What the photograph can be compared with. */
    public enum Other {
        /** No other picture. */
        NOTHING,
        /** The camera does not move. */
        AT_REST,
        /** The camera moves as in Newton's world. */
        GALILEAN_CAMERA,
        /** Brightness and colours do not change with the speed. */
        UNCHANGED_COLOURS,
        /** What the camera sees, if the picture shows where things are. */
        SEEN,
        /** Where things are at the time of the picture: not a photograph. */
        MEASURED,
        /** The camera has a shutter of another model. */
        OTHER_SHUTTER,
        /** The picture that is on the screen when this is chosen. */
        KEPT_PICTURE
    }

    private final JComboBox<Other> others = new JComboBox<>(Other.values());
    private final JComboBox<Class<?>> shutters = new JComboBox<>();
    private final JComboBox<Comparison> views =
            new JComboBox<>(new Comparison[] {Comparison.SPLIT, Comparison.BESIDE, Comparison.DIFFERENCE});
    private final Note hint = Note.ofLines(2);
    private final StudioModel model;
    private final Consumer<Compared> changed;
    private final Supplier<String> keeping;
    private String keptName;

    /** Whether nobody asked for this comparison: it is part of the scene with which the program begins. */
    private boolean ofScene;

    private final Updating updating = new Updating();

    /**
     * The panel.
     *
     * @param model what the photograph shows
     * @param changed notified of what the user wants to compare
     * @param keeping keeps the picture that is shown, and says what to call it
     */
    public ComparePanel(StudioModel model, Consumer<Compared> changed, Supplier<String> keeping) {
        super(Rows.column());
        this.model = model;
        this.changed = changed;
        this.keeping = keeping;
        Naming.items(others, Wording::label);
        Naming.name(others, "compare.name");
        Naming.items(views, Wording::label);
        Naming.name(views, "compare.view");
        Descriptions.members(Shutter.class).forEach(shutters::addItem);
        Naming.items(shutters, Wording::label);
        Naming.name(shutters, "compare.shutter");
        JPanel head = Rows.of("gap 6", "[pref!][grow,fill]");
        others.addActionListener(event -> updating.unless(this::choose));
        shutters.addActionListener(event -> updating.unless(this::tell));
        views.addActionListener(event -> updating.unless(this::tell));
        Rows.add(head, Texts.get("compare.name"), others, "wmin 0");
        panel.add(head, "wmin 0");
        panel.add(shutters, "wmin 0");
        panel.add(views, "wmin 0");
        panel.add(hint.component(), "wmin 0");
        model.addOpenListener(this::beginScene);
        model.addListener(this::update);
        update();
    }

    /**
     * Ends the comparison when a lesson begins, because it would show the answer beside the question. Ends the one of
     * the first scene when another scene is opened.
     */
    private void beginScene() {
        if (ofScene || model.studio().lesson() instanceof Lesson) {
            choose(Other.NOTHING);
        }
    }

    /** Chooses what to compare with, as the user does. */
    public void choose(Other other) {
        others.setSelectedItem(other);
    }

    /** Compares the scene with which the program begins, until another one is opened. */
    public void begin(Other other) {
        choose(other);
        ofScene = true;
    }

    /** Shows the picture of another shutter beside the picture, until another scene is opened. */
    public void compareShutter(Class<? extends Shutter> shutter) {
        updating.during(() -> {
            shutters.setSelectedItem(shutter);
            views.setSelectedItem(Comparison.BESIDE);
        });
        begin(Other.OTHER_SHUTTER);
    }

    private void choose() {
        ofScene = false;
        if (other() == Other.KEPT_PICTURE) {
            keptName = keeping.get();
        }
        if (other() == Other.OTHER_SHUTTER
                && shutters.getSelectedItem()
                        == model.studio().camera().shutter().getClass()) {
            // the shutter in use would show the same picture twice
            updating.during(
                    () -> shutters.setSelectedIndex((shutters.getSelectedIndex() + 1) % shutters.getItemCount()));
        }
        tell();
    }

    private void tell() {
        update();
        changed.accept(new Compared(other(), (Class<?>) shutters.getSelectedItem(), view(), otherName()));
    }

    private void update() {
        shutters.setVisible(other() == Other.OTHER_SHUTTER);
        boolean compares = other() != Other.NOTHING;
        views.setVisible(compares);
        hint.setText(compares ? Texts.get(view() == Comparison.SPLIT ? "compare.splitHint" : "compare.hint") : "");
    }

    private Other other() {
        return (Other) others.getSelectedItem();
    }

    private Comparison view() {
        return other() == Other.NOTHING ? Comparison.NONE : (Comparison) views.getSelectedItem();
    }

    private String otherName() {
        return switch (other()) {
            case OTHER_SHUTTER -> Wording.label((Class<?>) shutters.getSelectedItem());
            case KEPT_PICTURE -> keptName;
            default -> Wording.label(other());
        };
    }
}
