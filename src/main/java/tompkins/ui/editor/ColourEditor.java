package tompkins.ui.editor;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JColorChooser;
import org.joml.Vector3d;
import tompkins.property.NumberText;
import tompkins.ray.Colour;
import tompkins.ui.widget.Drawing;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.VectorFields;
import tompkins.ui.widget.Wording;

/** Controls for a colour: three numbers, which may be above 1, and a patch that opens a colour chooser. */
final class ColourEditor extends Part implements ValueEditor {

    private static final int LEVELS = 255;
    private static final int PATCH_WIDTH = 16;
    private static final int PATCH_HEIGHT = 14;
    private static final List<String> PARTS = List.of("red", "green", "blue");

    private final VectorFields fields;
    private final Consumer<Object> commit;
    private Colour colour = Colour.BLACK;

    ColourEditor(String property, String tip, Note note, Consumer<Object> commit) {
        super(Rows.of("gap 4", "[pref!][grow,fill][grow,fill][grow,fill]"));
        this.commit = commit;
        JButton patch = new JButton(new Drawing(PATCH_WIDTH, PATCH_HEIGHT, (g, button) -> paintPatch(g)));
        String name = Texts.get("colour.choose", Wording.label(property));
        Naming.name(patch, name, name);
        patch.addActionListener(event -> choose(patch, note));
        fields = new VectorFields(
                property,
                NumberKind.DOUBLE,
                PARTS,
                tip + ". " + Texts.get("colour.tip"),
                note,
                vector -> commit.accept(new Colour(vector.x(), vector.y(), vector.z())));
        panel.add(patch);
        fields.addInRow(panel);
    }

    private void choose(Component parent, Note note) {
        Color before = screenColour();
        Color chosen = JColorChooser.showDialog(parent, Texts.get("colour.title"), before);
        // a screen may show less than the colour; if no other was chosen, nothing must be lost
        if (chosen != null && !chosen.equals(before)) {
            note.attempt(() -> commit.accept(
                    new Colour(light(chosen.getRed()), light(chosen.getGreen()), light(chosen.getBlue()))));
        }
    }

    /** The factor that keeps light brighter than white as bright when its colour is chosen. */
    private double brightness() {
        return Math.max(1, Math.max(colour.red(), Math.max(colour.green(), colour.blue())));
    }

    private double light(int level) {
        return NumberText.rounded(brightness() * level / LEVELS, 4);
    }

    private void paintPatch(Graphics2D g) {
        g.setColor(screenColour());
        g.fillRect(0, 0, PATCH_WIDTH, PATCH_HEIGHT);
    }

    private Color screenColour() {
        return new Color(level(colour.red()), level(colour.green()), level(colour.blue()));
    }

    private int level(double light) {
        return (int) Math.rint(LEVELS * Math.max(0, light) / brightness());
    }

    @Override
    public void show(Object value) {
        colour = (Colour) value;
        fields.show(new Vector3d(colour.red(), colour.green(), colour.blue()));
        panel.repaint();
    }
}
