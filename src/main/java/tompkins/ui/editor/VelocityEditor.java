package tompkins.ui.editor;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.SpeedText;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.VectorFields;
import tompkins.ui.widget.Wording;

/** Controls for a velocity: its speed, in a notation that can be chosen, and below them its direction. */
final class VelocityEditor extends Part implements ValueEditor {

    private final JComboBox<SpeedScale> scales = new JComboBox<>(SpeedScale.values());
    private final EntryField speed;
    private final VectorFields direction;
    private final JPanel directionRow = Rows.of("gap 4, wrap 3", "[grow,fill][grow,fill][grow,fill]");
    private Velocity velocity = Velocity.REST;

    VelocityEditor(String tip, Note note, Consumer<Object> commit) {
        super(Rows.of("gap 4", "[pref!][grow,fill]"));
        Naming.items(scales, scale -> Texts.get("scale." + scale + ".name"));
        Naming.name(scales, "speed.scale");
        DefaultListCellRenderer names = (DefaultListCellRenderer) scales.getRenderer();
        scales.setRenderer((list, scale, place, selected, focused) -> {
            names.getListCellRendererComponent(list, scale, place, selected, focused);
            if (place < 0) {
                // beside the field there is room for a letter
                names.setText(Texts.get("scale." + scale));
            }
            return names;
        });
        scales.putClientProperty(FlatClientProperties.MINIMUM_WIDTH, 0);
        scales.addActionListener(event -> show(velocity));
        speed = new EntryField(
                new JTextField(6),
                Texts.get("speed.name"),
                tip + ". " + Texts.get("speed.tip"),
                note,
                text -> commit.accept(SpeedText.parse(text, scale(), velocity.givenDirection())));
        direction = new VectorFields(
                "direction",
                NumberKind.DOUBLE,
                VectorFields.AXES,
                Texts.get("direction.tip"),
                note,
                vector -> commit.accept(velocity.along(vector, scale())));
        panel.add(scales);
        panel.add(speed.field(), "wmin 40");
        directionRow.add(new JLabel(Wording.label("direction")), "span");
        direction.addInRow(directionRow);
    }

    private SpeedScale scale() {
        return (SpeedScale) scales.getSelectedItem();
    }

    @Override
    public Optional<JComponent> parts() {
        return Optional.of(directionRow);
    }

    @Override
    public void show(Object value) {
        velocity = (Velocity) value;
        speed.show(SpeedText.of(velocity, scale()));
        direction.showDirection(velocity.givenDirection());
    }
}
