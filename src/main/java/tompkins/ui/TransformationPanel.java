package tompkins.ui;

import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import tompkins.spacetime.TransformationLaw;

/** The law of motion: Einstein's, Newton's, or none. */
final class TransformationPanel {

    private final JPanel panel = Rows.column();

    TransformationPanel(StudioModel model) {
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

    JComponent component() {
        return panel;
    }
}
