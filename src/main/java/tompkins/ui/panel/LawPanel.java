package tompkins.ui.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.JToggleButton;
import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.ChoiceRow;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/** A choice between a few laws of nature, or between the views of a scene. */
public final class LawPanel extends Part {

    private <L extends Enum<L>> LawPanel(
            StudioModel model, L[] laws, Function<Studio, L> reading, BiFunction<Studio, L, Studio> change) {
        super(Rows.column());
        add(panel, model, List.of(laws), law -> new JRadioButton(Wording.label(law)), reading, change);
    }

    /** A row of buttons for what the motion does to the colours. */
    public static JPanel quickColours(StudioModel model) {
        List<ColourLaw> laws = List.of(ColourLaw.UNCHANGED, ColourLaw.DOPPLER, ColourLaw.SEARCHLIGHT);
        return quick(model, laws, Studio::colours, Studio::withColours);
    }

    /** A row of buttons for what is seen, or measured. */
    public static JPanel quickView(StudioModel model) {
        return quick(model, List.of(View.values()), Studio::view, Studio::withView);
    }

    private static <L extends Enum<L>> JPanel quick(
            StudioModel model, List<L> laws, Function<Studio, L> reading, BiFunction<Studio, L, Studio> change) {
        JPanel row = Rows.of("gap 2", "[grow,fill]".repeat(laws.size()));
        add(row, model, laws, LawPanel::quick, reading, change);
        return row;
    }

    private static JToggleButton quick(Enum<?> law) {
        JToggleButton button = new JToggleButton(Texts.get("quick." + law.name()));
        button.putClientProperty(FlatClientProperties.STYLE, ChoiceRow.STYLE);
        return button;
    }

    private static <L extends Enum<L>> void add(
            JPanel panel,
            StudioModel model,
            List<L> laws,
            Function<L, JToggleButton> buttons,
            Function<Studio, L> reading,
            BiFunction<Studio, L, Studio> change) {
        ButtonGroup group = new ButtonGroup();
        for (L law : laws) {
            JToggleButton button = buttons.apply(law);
            Naming.name(button, button.getText(), Texts.get("law." + law.name()));
            ChoiceRow.whenChosen(button, () -> {
                if (reading.apply(model.studio()) != law) {
                    model.set(change.apply(model.studio(), law));
                }
            });
            group.add(button);
            panel.add(button, "wmin 0");
            Runnable update = () -> button.setSelected(reading.apply(model.studio()) == law);
            model.follow(update);
        }
    }

    /** The law of motion of the studio in a model: Einstein's, Newton's, or none. */
    public static LawPanel ofTransformation(StudioModel model) {
        return new LawPanel(model, TransformationLaw.values(), Studio::transformation, Studio::withTransformation);
    }

    /** Whether the picture of the studio in a model shows what is seen, or what is measured. */
    public static LawPanel ofView(StudioModel model) {
        return new LawPanel(model, View.values(), Studio::view, Studio::withView);
    }

    /** What the motion does to the colours of the studio in a model. */
    public static LawPanel ofColours(StudioModel model) {
        LawPanel colours = new LawPanel(model, ColourLaw.values(), Studio::colours, Studio::withColours);
        Note note = Note.ofLines(2);
        note.setText(missingEffectOnColours(model.studio()));
        model.addListener(() -> note.setText(missingEffectOnColours(model.studio())));
        colours.panel.add(meter(model));
        colours.panel.add(note.component(), "wmin 0");
        return colours;
    }

    private static JCheckBox meter(StudioModel model) {
        JCheckBox meter = new JCheckBox(Texts.get("colours.meter"));
        Naming.name(meter, meter.getText(), Texts.get("colours.meterTip"));
        meter.addActionListener(
                event -> model.set(model.studio().withMetering(meter.isSelected() ? Metering.MIDDLE : Metering.NONE)));
        Runnable update = () -> {
            meter.setSelected(model.studio().metering() == Metering.MIDDLE);
            meter.setEnabled(model.studio().shiftsColours());
        };
        model.follow(update);
        return meter;
    }

    private static String missingEffectOnColours(Studio studio) {
        return studio.shiftsColours() || studio.colours() == ColourLaw.UNCHANGED ? "" : Texts.get("colours.noEffect");
    }
}
