package tompkins.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Fields for the two or three components of a vector. */
final class VectorFields {

    private static final String[] AXES = {"x", "y", "z"};

    private final List<NumberField> fields = new ArrayList<>();
    private final Vector3d value = new Vector3d();

    /**
     * Fields for a property.
     *
     * @param property its name, for messages
     * @param axes how many fields there are; components without a field are 0
     * @param commit takes the vector, or throws
     */
    VectorFields(String property, int axes, String tip, Note note, Consumer<Vector3dc> commit) {
        for (int axis = 0; axis < axes; axis++) {
            int component = axis;
            String name = Wording.label(property) + " " + AXES[axis];
            fields.add(new NumberField(property + " (" + AXES[axis] + ")", name, tip, note, number -> {
                Vector3d next = new Vector3d(value);
                next.setComponent(component, number);
                commit.accept(next);
                value.set(next);
            }));
        }
    }

    /** Adds the fields one under the other, each after its name. */
    void addInColumn(JPanel panel) {
        for (int axis = 0; axis < fields.size(); axis++) {
            JLabel label = new JLabel(AXES[axis]);
            label.setLabelFor(fields.get(axis).field());
            panel.add(label);
            panel.add(fields.get(axis).field(), "wmin 40");
        }
    }

    /** Adds the fields side by side. */
    void addInRow(JPanel panel) {
        for (NumberField field : fields) {
            panel.add(field.field(), "growx, wmin 40, sizegroup vector");
        }
    }

    void show(Vector3dc vector) {
        value.set(vector);
        for (int axis = 0; axis < fields.size(); axis++) {
            fields.get(axis).show(vector.get(axis));
        }
    }
}
