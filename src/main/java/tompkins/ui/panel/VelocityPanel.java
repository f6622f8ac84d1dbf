package tompkins.ui.panel;

import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.property.NumberText;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.ChoiceRow;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.SpeedText;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.ValueSlider;
import tompkins.ui.widget.VectorFields;
import tompkins.ui.widget.Wording;

/** How fast the camera moves, and in which direction. */
public final class VelocityPanel extends Part {

    /**
     * The speeds of the slider, as rapidities: from rest to gamma 10, where most is seen to change, and to gamma 202.
     */
    private static final Range RAPIDITIES = Range.bent(0, 3, 6);

    private final StudioModel model;
    private final Note note = Note.ofLines(3);
    private final ValueSlider slider;
    private final EntryField speed;
    private final VectorFields direction;
    private final JPanel more = Rows.column();
    private SpeedScale scale = SpeedScale.BETA;

    /** A panel for the camera's velocity in the studio of a model, which follows its changes. */
    public VelocityPanel(StudioModel model) {
        super(Rows.column());
        this.model = model;
        slider = new ValueSlider(
                Texts.get("speed.slider"), Texts.get("speed.sliderTip"), RAPIDITIES, this::slide, model::endGesture);
        speed = new EntryField(
                new JTextField(7), Texts.get("speed.name"), Texts.get("speed.tip"), note, this::enterSpeed);
        direction = VectorFields.ofDirection(note, this::turn);
        JPanel speedRow = Rows.of("gap 6", "[grow,fill][pref!]");
        speedRow.add(slider.slider(), "wmin 40");
        speedRow.add(speed.field(), "growx");
        panel.add(speedRow);
        more.add(scaleSwitch());
        more.add(new JLabel(Wording.label("direction")));
        more.add(directionRow());
        more.add(buttons());
        panel.add(more);
        panel.add(note.component(), "wmin 0");
        model.follow(this::update);
    }

    /** Shows the speed alone, or the direction and the scales, too. */
    public void setBrief(boolean brief) {
        more.setVisible(!brief);
    }

    private JComponent scaleSwitch() {
        return ChoiceRow.of(
                List.of(SpeedScale.values()),
                each -> Texts.get("scale." + each.name()),
                VelocityPanel::name,
                each -> name(each) + ", " + each.range(),
                each -> {
                    scale = each;
                    update();
                });
    }

    private static String name(SpeedScale scale) {
        return Texts.get("scale." + scale.name() + ".name");
    }

    private JComponent directionRow() {
        JPanel row = Rows.of("gap 4", "[grow,fill][grow,fill][grow,fill]");
        direction.addInRow(row);
        return row;
    }

    private JComponent buttons() {
        JPanel row = Rows.of("wrap 2, gap 4", "[grow,fill,sg][grow,fill,sg]");
        row.add(Buttons.of("velocity.rest", this::rest));
        row.add(Buttons.of("velocity.forwards", () -> turn(camera().viewDirection())));
        row.add(Buttons.of("velocity.backwards", () -> turn(new Vector3d().sub(camera().viewDirection()))));
        row.add(Buttons.of("velocity.sideways", () -> turn(camera().rightDirection())));
        return row;
    }

    private void rest() {
        take(Velocity.of(SpeedScale.BETA, 0, velocity().givenDirection()));
        // a speed that was refused: the camera was at rest already
        speed.revert();
    }

    private Camera camera() {
        return model.studio().camera();
    }

    private Velocity velocity() {
        return model.studio().velocity();
    }

    private void slide(double rapidity, Object gesture) {
        Velocity exact = Velocity.of(SpeedScale.RAPIDITY, rapidity, velocity().givenDirection());
        model.adjust(FrontWindow.withVelocity(model.studio(), rounded(exact)), gesture);
    }

    /** A speed with no more digits than a hand can choose, on the scale that is shown. */
    private Velocity rounded(Velocity velocity) {
        double value = scale == SpeedScale.BETA
                ? 1 - NumberText.rounded(velocity.oneMinusSpeed(), velocity.speed() < 0.9 ? 3 : 2)
                : NumberText.rounded(scale.valueOf(velocity), 4);
        return Velocity.of(scale, NumberText.rounded(value, 12), velocity.given());
    }

    private void enterSpeed(String text) {
        take(SpeedText.parse(text, scale, velocity().givenDirection()));
    }

    private void turn(Vector3dc to) {
        take(velocity().along(to, scale));
    }

    private void take(Velocity velocity) {
        model.set(FrontWindow.withVelocity(model.studio(), velocity));
    }

    private void update() {
        Velocity now = velocity();
        slider.show(now.rapidity());
        speed.show(SpeedText.of(now, scale));
        direction.showDirection(now.givenDirection());
        String beta = SpeedText.vector(now);
        TransformationLaw law = model.studio().transformation();
        String numbers = switch (law) {
            case LORENTZ ->
                Texts.get("velocity.numbers", SpeedScale.GAMMA.reading(now), SpeedScale.RAPIDITY.reading(now), beta);
            case GALILEAN -> Texts.get("velocity.beta", beta);
            case NONE -> Texts.get("velocity.ignored", beta);
        };
        law.warning(now).ifPresentOrElse(note::setUsualError, () -> note.setUsual(numbers));
    }
}
