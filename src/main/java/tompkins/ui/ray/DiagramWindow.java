package tompkins.ui.ray;

import java.awt.Component;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Screens;
import tompkins.ui.widget.Texts;

/** A space-time diagram in a window of its own, as large as one likes, above the text that explains it. */
public final class DiagramWindow {

    /** Its size at first, in sizes of the type. */
    private static final double SIZE = 34;

    private final DiagramPane diagram = new DiagramPane(SIZE);
    private final Note text = new Note("");

    /** Null until it is first opened. */
    private JDialog dialog;

    /** Shows a diagram from now on, whether it is open or not; null for none. */
    public void show(SpaceTimeDiagram drawn, String explanation) {
        diagram.show(drawn, explanation);
        text.setText(drawn == null ? "" : explanation);
    }

    /** Opens it beside the window of a component. */
    public void open(Component beside) {
        if (dialog == null) {
            dialog = new JDialog(SwingUtilities.getWindowAncestor(beside), Texts.get("ray.diagram"));
            dialog.setName("diagram");
            JPanel content = Rows.of("insets 8, fill, wrap", "[grow,fill]");
            content.add(diagram, "grow, push");
            content.add(text.component(), "wmin 0");
            dialog.setContentPane(content);
            Keys.bindEscape(dialog.getRootPane(), dialog::dispose);
            dialog.pack();
            Screens.moveBeside(dialog, dialog.getOwner());
        }
        dialog.setVisible(true);
    }
}
