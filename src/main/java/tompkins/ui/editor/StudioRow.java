package tompkins.ui.editor;

import java.lang.reflect.RecordComponent;
import java.util.function.Function;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.property.Descriptions;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.ValueSlider;
import tompkins.ui.widget.Wording;

/**
 * A part of the studio in a panel: its name, a slider if it is a number with a range, and the controls that the form of
 * the editor has for it. It follows the studio, and is hidden where the studio has no such part.
 */
public final class StudioRow {

    private final StudioModel model;

    /** The way to the number of the slider. */
    private final StudioPath number;

    /** The way to what the editor edits: a velocity is edited as a whole. */
    private final StudioPath part;

    private final Function<Studio, Range> range;
    private final Note note;
    private final JLabel label;
    private final ValueEditor editor;
    private final JPanel cell = Rows.of("hidemode 3, gap 6 4", "[grow,fill][pref!]");

    /** Null if the row has none. */
    private final ValueSlider slider;

    /** A row without a slider. */
    public StudioRow(StudioModel model, String path, String name) {
        this(model, path, name, new Note(""), null);
    }

    /**
     * A row.
     *
     * @param path the way from the studio, such as {@code camera.shutter.openingTime}
     * @param name the name that stands before it
     * @param note what is said below it
     * @param range where its slider runs, by the studio; null for none
     */
    public StudioRow(StudioModel model, String path, String name, Note note, Function<Studio, Range> range) {
        this.model = model;
        this.note = note;
        this.range = range;
        number = StudioPath.parse(path).orElseThrow();
        StudioPath way = StudioPath.ROOT;
        Class<?> type = Studio.class;
        RecordComponent component = null;
        for (Object step : number.steps()) {
            if (type != Velocity.class) {
                component = component(type, (String) step);
                type = component.getType();
                way = way.then(step);
            }
        }
        part = way;
        editor = ValueEditors.of(component, note, value -> model.set(PartChange.with(model.studio(), part, value)));
        label = new JLabel(name);
        label.setLabelFor(editor.component());
        String tip = Wording.meaning(component);
        Naming.tip(label, tip);
        slider = range == null
                ? null
                : new ValueSlider(
                        Texts.get("slider.name", name),
                        tip,
                        range.apply(model.studio()),
                        (value, gesture) -> note.attempt(
                                () -> model.adjust(PartChange.with(model.studio(), number, value), gesture)),
                        model::endGesture);
    }

    /** The component of a record type, or of the first type of a family that has it. */
    private static RecordComponent component(Class<?> type, String name) {
        return Descriptions.members(type).stream()
                .flatMap(member -> Descriptions.find(member, name).stream())
                .findFirst()
                .orElseThrow();
    }

    /** Adds the row to a panel of {@link Rows}, and follows the studio from now on. */
    public void addTo(JPanel panel) {
        panel.add(label);
        panel.add(cell, slider == null ? "span, growx, wmin 0" : "span, growx");
        if (slider == null) {
            cell.add(editor.component(), "span, wmin 0");
        } else if (part.equals(number)) {
            cell.add(slider.slider(), "wmin 40");
            cell.add(editor.component());
        } else {
            // the controls of what has several parts leave no room
            cell.add(editor.component(), "span");
            panel.add(slider.slider(), "span, growx");
        }
        panel.add(note.component(), "span, growx, wmin 0");
        model.follow(this::update);
    }

    private void update() {
        Studio studio = model.studio();
        boolean there = number.length(studio) == number.steps().size();
        label.setVisible(there);
        cell.setVisible(there);
        if (!there) {
            EntryField.in(cell).forEach(EntryField::revert);
            return;
        }
        editor.show(part.get(studio));
        if (slider != null) {
            slider.setRange(range.apply(studio));
            slider.show((Double) number.get(studio));
        }
    }
}
