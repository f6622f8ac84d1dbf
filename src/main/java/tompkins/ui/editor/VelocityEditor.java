package tompkins.ui.editor;

import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JTextField;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.SpeedText;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.VectorFields;
import tompkins.ui.widget.Wording;

/** Controls for a velocity in a form: its speed as it is written, and its direction. */
final class VelocityEditor extends Part implements ValueEditor {

    private final EntryField speed;
    private final VectorFields direction;
    private Velocity velocity = Velocity.REST;

    VelocityEditor(String tip, Note note, Consumer<Object> commit) {
        super(Rows.of("wrap 3, gap 4", "[grow,fill][grow,fill][grow,fill]"));
        speed = new EntryField(
                new JTextField(),
                Texts.get("speed.name"),
                tip + ". " + Texts.get("speed.tip"),
                note,
                text -> commit.accept(SpeedText.parse(text, SpeedScale.BETA, velocity.givenDirection())));
        direction = VectorFields.ofDirection(note, vector -> commit.accept(velocity.along(vector, SpeedScale.BETA)));
        panel.add(new JLabel(Texts.get("speed.name")), "span");
        panel.add(speed.field(), "span, growx, wmin 0");
        panel.add(new JLabel(Wording.label("direction")), "span");
        direction.addInRow(panel);
    }

    @Override
    public boolean isTall() {
        return true;
    }

    @Override
    public void show(Object value) {
        velocity = (Velocity) value;
        speed.show(
                velocity.scale() == null
                        ? SpeedText.of(velocity, SpeedScale.BETA)
                        : switch (velocity.scale()) {
                            case BETA -> Numbers.text(velocity.speed());
                            case GAMMA -> "gamma " + Numbers.text(velocity.value());
                            case RAPIDITY -> "rapidity " + Numbers.text(velocity.value());
                            case ONE_MINUS_BETA -> "1-" + Numbers.text(velocity.value());
                        });
        direction.showDirection(velocity.givenDirection());
    }
}
