package tompkins.ui.editor;

import java.lang.reflect.RecordComponent;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.joml.Vector2i;
import org.joml.Vector2ic;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector3i;
import org.joml.Vector3ic;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;
import tompkins.spacetime.Velocity;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.ProseArea;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.VectorFields;
import tompkins.ui.widget.Wording;

/** Chooses the controls for a component of a description by its type. */
final class ValueEditors {

    private static final Map<Class<?>, NumberKind> NUMBERS =
            Map.of(double.class, NumberKind.DOUBLE, int.class, NumberKind.INT, long.class, NumberKind.LONG);

    private ValueEditors() {}

    /**
     * Controls for a component.
     *
     * @param note where messages go
     * @param commit takes a new value, or throws {@link InvalidPropertyException}
     */
    static ValueEditor of(RecordComponent component, Note note, Consumer<Object> commit) {
        Class<?> type = component.getType();
        String name = component.getName();
        String label = Wording.label(name);
        String tip = Wording.meaning(component);
        if (NUMBERS.containsKey(type)) {
            NumberField field = new NumberField(NUMBERS.get(type), name, label, tip, note, commit);
            return editor(field.field(), value -> field.show((Number) value));
        }
        if (type == String.class) {
            return component.getAnnotation(Meaning.class).prose()
                    ? text(new EntryField(new ProseArea(), label, tip, note, commit::accept), true)
                    : text(new EntryField(new JTextField(), label, tip, note, commit::accept), false);
        }
        if (type == boolean.class) {
            return check(label, tip, note, commit);
        }
        if (type.isEnum()) {
            return choice(type, label, tip, note, commit);
        }
        if (type == Vector3dc.class) {
            return vector(new VectorFields(name, NumberKind.DOUBLE, VectorFields.AXES, tip, note, commit::accept));
        }
        if (type == Vector3ic.class) {
            return vector(new VectorFields(
                    name,
                    NumberKind.INT,
                    VectorFields.AXES,
                    tip,
                    note,
                    v -> commit.accept(new Vector3i((int) v.x(), (int) v.y(), (int) v.z()))));
        }
        if (type == Vector2ic.class) {
            return vector(new VectorFields(
                    name,
                    NumberKind.INT,
                    VectorFields.AXES.subList(0, 2),
                    tip,
                    note,
                    v -> commit.accept(new Vector2i((int) v.x(), (int) v.y()))));
        }
        if (type == Colour.class) {
            return new ColourEditor(name, tip, note, commit);
        }
        if (type == Velocity.class) {
            return new VelocityEditor(tip, note, commit);
        }
        if (type == PixelPicture.class) {
            return FileContentEditor.picture(label, tip, note, commit);
        }
        if (type == MeshData.class) {
            return FileContentEditor.mesh(label, tip, note, commit);
        }
        if (Descriptions.isDescription(type)) {
            return new FamilyEditor(type, label, note, commit);
        }
        throw new IllegalArgumentException("no editor for " + component);
    }

    private static ValueEditor text(EntryField field, boolean isTall) {
        return new PlainEditor(field.field(), isTall, value -> field.show((String) value));
    }

    private static ValueEditor vector(VectorFields fields) {
        JPanel row = Rows.of("gap 4, flowx", "[grow,fill]");
        fields.addInRow(row);
        return editor(row, value -> fields.show(asDoubles(value)));
    }

    private static Vector3dc asDoubles(Object vector) {
        if (vector instanceof Vector2ic two) {
            return new Vector3d(two.x(), two.y(), 0);
        }
        return vector instanceof Vector3ic three ? new Vector3d(three) : (Vector3dc) vector;
    }

    private static ValueEditor check(String label, String tip, Note note, Consumer<Object> commit) {
        JCheckBox box = new JCheckBox();
        Naming.name(box, label, tip);
        box.addActionListener(event -> {
            if (!note.attempt(() -> commit.accept(box.isSelected()))) {
                box.setSelected(!box.isSelected());
            }
        });
        return editor(box, value -> box.setSelected((Boolean) value));
    }

    private static ValueEditor choice(Class<?> type, String label, String tip, Note note, Consumer<Object> commit) {
        JComboBox<Object> box = new JComboBox<>(type.getEnumConstants());
        Naming.items(box, value -> Wording.label((Enum<?>) value));
        Naming.name(box, label, tip);
        Updating updating = new Updating();
        box.addActionListener(event -> updating.unless(() -> note.attempt(() -> commit.accept(box.getSelectedItem()))));
        return editor(box, value -> updating.during(() -> box.setSelectedItem(value)));
    }

    private static ValueEditor editor(JComponent component, Consumer<Object> show) {
        return new PlainEditor(component, false, show);
    }

    private record PlainEditor(JComponent component, boolean isTall, Consumer<Object> shows) implements ValueEditor {

        @Override
        public void show(Object value) {
            shows.accept(value);
        }
    }
}
