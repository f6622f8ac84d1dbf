package tompkins.ui.panel;

import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import tompkins.spacetime.TransformationLaw;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The law of motion: Einstein's, Newton's, or none. */
public final class TransformationPanel {

    private final JPanel panel = Rows.column();

    /** A panel for the change of frame of the studio in a model, which follows its changes. */
    public TransformationPanel(StudioModel model) {
        ButtonGroup group = new ButtonGroup();
        for (TransformationLaw law : TransformationLaw.values()) {
            JRadioButton button = new JRadioButton(Texts.get("law." + law.name()));
            Naming.name(button, button.getText(), Texts.get("law." + law.name() + ".tip"));
            button.addActionListener(event -> model.set(model.studio().withTransformation(law)));
            group.add(button);
            panel.add(button);
            Runnable update = () -> button.setSelected(model.studio().transformation() == law);
            model.addListener(update);
            update.run();
        }
    }

    /** The panel itself. */
    public JComponent component() {
        return panel;
    }
}
