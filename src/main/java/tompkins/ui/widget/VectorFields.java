package tompkins.ui.widget;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.text.JTextComponent;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;

/** Fields for the two or three components of a vector, or of a colour. */
public final class VectorFields {

    /** The names of the components of a vector. */
    public static final List<String> AXES = List.of("x", "y", "z");

    private static final int DIRECTION_DIGITS = 4;

    private final List<String> names;
    private final List<NumberField> fields = new ArrayList<>();
    private final Vector3d value = new Vector3d();
    private Vector3dc typed;

    /**
     * Fields for a property.
     *
     * @param property its name, for messages
     * @param kind which numbers the fields take
     * @param names the names of the components, one for each field; components without a field are 0
     * @param commit takes the vector, or throws
     */
    public VectorFields(
            String property, NumberKind kind, List<String> names, String tip, Note note, Consumer<Vector3dc> commit) {
        this.names = names;
        for (int axis = 0; axis < names.size(); axis++) {
            int component = axis;
            String name = Wording.label(property) + " " + names.get(axis);
            fields.add(new NumberField(kind, property + " (" + names.get(axis) + ")", name, tip, note, number -> {
                Vector3d next = new Vector3d(value);
                next.setComponent(component, number.doubleValue());
                typed = next;
                commit.accept(next);
                value.set(next);
            }));
        }
    }

    /** Adds the fields side by side, each with its name in it. */
    public void addInRow(JPanel panel) {
        for (int axis = 0; axis < fields.size(); axis++) {
            JLabel label = new JLabel(Texts.getOr("component." + names.get(axis), names.get(axis)));
            label.putClientProperty(FlatClientProperties.STYLE, "font: $small.font; foreground: $Tompkins.note");
            label.setBorder(BorderFactory.createEmptyBorder(0, 4, 0, 2));
            JTextComponent field = fields.get(axis).field();
            field.putClientProperty(FlatClientProperties.TEXT_FIELD_LEADING_COMPONENT, label);
            panel.add(field, "growx, wmin 40, sizegroup vector");
        }
    }

    /**
     * Shows a direction as a unit vector, so that nobody takes it for a velocity; if it was typed here it is shown as
     * it was typed, so that a second number does not change the first.
     */
    public void showDirection(Vector3dc direction) {
        show(direction.equals(typed) ? direction : Numbers.rounded(Vectors.unit(direction), DIRECTION_DIGITS));
    }

    /** Shows the components of a vector. */
    public void show(Vector3dc vector) {
        value.set(vector);
        for (int axis = 0; axis < fields.size(); axis++) {
            fields.get(axis).show(vector.get(axis));
        }
    }
}
