package tompkins.ui.editor;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.Arrays;
import java.util.Locale;
import java.util.ResourceBundle;
import javax.swing.Icon;
import tompkins.ui.widget.Drawing;

/** Tiny drawings of objects and surfaces, for the lists of types; the file of the drawings explains its letters. */
final class TypeIcon {

    private static final ResourceBundle DRAWINGS =
            ResourceBundle.getBundle("tompkins.ui.editor.TypeIcons", Locale.ROOT);

    private static final int WIDTH = 26;
    private static final int HEIGHT = 18;
    private static final int OPACITY_OF_RAYS = 170;

    private TypeIcon() {}

    /** The drawing of a type, in the colour of the text beside it; null if it has none. */
    static Icon of(Class<?> type) {
        String name = type.getSimpleName();
        if (!DRAWINGS.containsKey(name)) {
            return null;
        }
        String[] strokes = DRAWINGS.getString(name).split(";");
        return new Drawing(
                WIDTH,
                HEIGHT,
                (g, beside) -> Arrays.stream(strokes)
                        .map(stroke -> stroke.strip().split(" "))
                        .forEach(stroke -> paint(g, beside, stroke)));
    }

    private static void paint(Graphics2D g, Component beside, String[] stroke) {
        String letter = stroke[0].toLowerCase(Locale.ROOT);
        boolean isRay = letter.equals("r");
        Color ink = beside.getForeground();
        g.setColor(isRay ? new Color(ink.getRed(), ink.getGreen(), ink.getBlue(), OPACITY_OF_RAYS) : ink);
        g.setStroke(new BasicStroke(isRay ? 1 : 1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        double[] numbers =
                Arrays.stream(stroke).skip(1).mapToDouble(Double::parseDouble).toArray();
        Shape shape = letter.equals("o")
                ? new Ellipse2D.Double(numbers[0] - numbers[2], numbers[1] - numbers[3], 2 * numbers[2], 2 * numbers[3])
                : path(numbers);
        if (letter.equals(stroke[0])) {
            g.draw(shape);
        } else {
            g.fill(shape);
        }
    }

    private static Path2D path(double[] numbers) {
        Path2D path = new Path2D.Double();
        path.moveTo(numbers[0], numbers[1]);
        for (int i = 2; i < numbers.length; i += 2) {
            path.lineTo(numbers[i], numbers[i + 1]);
        }
        return path;
    }
}
