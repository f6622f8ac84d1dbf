package tompkins.ui.compare;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import net.miginfocom.swing.MigLayout;
import tompkins.lesson.Lesson;
import tompkins.property.Descriptions;
import tompkins.shutter.Shutter;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Comparison;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.ChoiceRow;
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
        /** A picture that was on the screen before. */
        KEPT_PICTURE
    }

    private final JComboBox<Other> others = new JComboBox<>();
    private final JComboBox<Class<?>> shutters = new JComboBox<>();
    private final Map<Comparison, JRadioButton> views = new EnumMap<>(Comparison.class);
    private final JButton peek = new JButton(Texts.get("compare.peek"));
    private final Note hint = Note.ofLines(2);
    private final StudioModel model;
    private final Consumer<Compared> changed;
    private String keptName;

    /** Whether nobody asked for this comparison: it is part of the scene with which the program begins. */
    private boolean ofScene;

    private final Updating updating = new Updating();

    /**
     * The panel.
     *
     * @param model what the photograph shows
     * @param changed notified of what the user wants to compare
     * @param peeking notified when the other picture should be shown alone, and when no longer
     * @param keeping keeps the picture that is shown, and says what to call it
     */
    public ComparePanel(
            StudioModel model, Consumer<Compared> changed, Consumer<Boolean> peeking, Supplier<String> keeping) {
        super(Rows.column());
        this.model = model;
        this.changed = changed;
        // the kept picture can be chosen once one is kept
        Stream.of(Other.values()).filter(other -> other != Other.KEPT_PICTURE).forEach(others::addItem);
        Naming.items(others, Wording::label);
        Naming.name(others, "compare.name");
        Descriptions.members(Shutter.class).forEach(shutters::addItem);
        Naming.items(shutters, Wording::label);
        Naming.name(shutters, "compare.shutter");
        Naming.name(peek, "compare.peek");
        peek.getModel()
                .addChangeListener(event -> peeking.accept(peek.getModel().isPressed()));
        others.addActionListener(event -> updating.unless(this::choose));
        shutters.addActionListener(event -> updating.unless(this::tell));
        JPanel buttons = Rows.of("wrap 1, gap 4", "[grow,fill]");
        buttons.add(Buttons.of("compare.keep", () -> keep(keeping.get())));
        buttons.add(peek);
        panel.add(others, "wmin 0");
        panel.add(shutters, "wmin 0");
        panel.add(views());
        panel.add(buttons);
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

    private JPanel views() {
        JPanel row = new JPanel(new MigLayout("novisualpadding, insets 0, gap 12"));
        row.setOpaque(false);
        ButtonGroup group = new ButtonGroup();
        for (Comparison view : List.of(Comparison.SPLIT, Comparison.BESIDE, Comparison.DIFFERENCE)) {
            JRadioButton button = new JRadioButton(Wording.label(view), view == Comparison.SPLIT);
            Naming.name(button, button.getText(), Texts.get("compare.tip." + view));
            ChoiceRow.whenChosen(button, this::tell);
            group.add(button);
            row.add(button);
            views.put(view, button);
        }
        return row;
    }

    private void keep(String name) {
        if (keptName == null) {
            others.addItem(Other.KEPT_PICTURE);
        }
        keptName = name;
        choose(Other.KEPT_PICTURE);
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
            views.get(Comparison.BESIDE).setSelected(true);
        });
        begin(Other.OTHER_SHUTTER);
    }

    private void choose() {
        ofScene = false;
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
        changed.accept(compared());
    }

    private Compared compared() {
        return new Compared(other(), (Class<?>) shutters.getSelectedItem(), view(), otherName());
    }

    private void update() {
        shutters.setVisible(other() == Other.OTHER_SHUTTER);
        boolean compares = other() != Other.NOTHING;
        views.values().forEach(button -> button.setEnabled(compares));
        peek.setEnabled(compares);
        hint.setText(compares ? hint() : "");
    }

    private String hint() {
        if (compared().isSame(model.studio())) {
            return Texts.get("compare.same");
        }
        return Texts.get(view() == Comparison.SPLIT ? "compare.splitHint" : "compare.hint");
    }

    private Other other() {
        return (Other) others.getSelectedItem();
    }

    private Comparison view() {
        return other() == Other.NOTHING
                ? Comparison.NONE
                : views.keySet().stream()
                        .filter(view -> views.get(view).isSelected())
                        .findFirst()
                        .orElseThrow();
    }

    private String otherName() {
        return switch (other()) {
            case OTHER_SHUTTER -> Wording.label((Class<?>) shutters.getSelectedItem());
            case KEPT_PICTURE -> keptName;
            default -> Wording.label(other());
        };
    }
}
