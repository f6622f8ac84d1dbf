package tompkins.ui.widget;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.Arrays;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.stream.Stream;
import javax.swing.Icon;
import javax.swing.UIManager;
import tompkins.shutter.Shutter;

/** Tiny drawings of objects, surfaces and shutters; the file of the drawings explains its letters. */
public final class TinyDrawing {

    private static final ResourceBundle DRAWINGS = ResourceBundle.getBundle("tompkins.ui.TinyDrawings", Locale.ROOT);

    private static final int WIDTH = 26;
    private static final int HEIGHT = 18;
    private static final int SHUTTER_WIDTH = 41;
    private static final double SHUTTER_SCALE = HEIGHT / 28.0;
    private static final int OPACITY_OF_RAYS = 170;

    private TinyDrawing() {}

    /** The drawing of a type, in the colours of the look and of the text beside it; null if it has none. */
    public static Icon of(Class<?> type) {
        String name = name(type);
        if (!DRAWINGS.containsKey(name)) {
            return null;
        }
        // a camera is wide, and drawn in a larger square
        double scale = Shutter.class.isAssignableFrom(type) ? SHUTTER_SCALE : 1;
        String[] strokes = DRAWINGS.getString(name).split(";");
        return new Drawing(scale < 1 ? SHUTTER_WIDTH : WIDTH, HEIGHT, (g, beside) -> {
            g.scale(scale, scale);
            Arrays.stream(strokes).map(stroke -> stroke.strip().split(" ")).forEach(stroke -> paint(g, beside, stroke));
        });
    }

    private static void paint(Graphics2D g, Component beside, String[] stroke) {
        int letterAt = 0;
        while (stroke[letterAt].length() > 1) {
            letterAt++;
        }
        char letter = stroke[letterAt].charAt(0);
        boolean isRay = letter == 'r';
        Color colour = beside.getForeground();
        float width = isRay ? 1 : 1.5f;
        int opacity = isRay ? OPACITY_OF_RAYS : 255;
        float[] dashes = null;
        for (String word : Arrays.copyOf(stroke, letterAt)) {
            String value = word.substring(1);
            switch (word.charAt(0)) {
                case 'w' -> width = Float.parseFloat(value);
                case 't' -> opacity = Integer.parseInt(value);
                case 'd' -> dashes = new float[] {Float.parseFloat(value), Float.parseFloat(value)};
                default -> colour = UIManager.getColor(word);
            }
        }
        g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), opacity));
        int cap = dashes == null ? BasicStroke.CAP_ROUND : BasicStroke.CAP_BUTT;
        g.setStroke(new BasicStroke(width, cap, BasicStroke.JOIN_ROUND, 10, dashes, 0));
        double[] numbers = Stream.of(stroke)
                .skip(letterAt + 1L)
                .mapToDouble(Double::parseDouble)
                .toArray();
        Shape shape = shape(Character.toLowerCase(letter), numbers);
        if (Character.isLowerCase(letter)) {
            g.draw(shape);
        } else {
            g.fill(shape);
        }
    }

    /** The name of the drawing of a type; what other jars add has one for all of its kind. */
    private static String name(Class<?> type) {
        return Stream.of(type.getInterfaces())
                .map(Class::getSimpleName)
                .filter(DRAWINGS::containsKey)
                .findFirst()
                .orElse(type.getSimpleName());
    }

    private static Shape shape(char letter, double... numbers) {
        if (letter == 'l' || letter == 'r') {
            Path2D path = new Path2D.Double();
            path.moveTo(numbers[0], numbers[1]);
            for (int i = 2; i < numbers.length; i += 2) {
                path.lineTo(numbers[i], numbers[i + 1]);
            }
            return path;
        }
        Ellipse2D around =
                new Ellipse2D.Double(numbers[0] - numbers[2], numbers[1] - numbers[3], 2 * numbers[2], 2 * numbers[3]);
        return letter == 'a' ? new Arc2D.Double(around.getBounds2D(), numbers[4], numbers[5], Arc2D.OPEN) : around;
    }
}
