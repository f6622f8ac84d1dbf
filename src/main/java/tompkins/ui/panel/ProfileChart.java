package tompkins.ui.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.stream.DoubleStream;
import javax.swing.JPanel;
import javax.swing.UIManager;
import tompkins.measure.Profile;
import tompkins.measure.RayTable;
import tompkins.measure.Sighting;
import tompkins.ui.widget.Numbers;

/** A small chart of columns of a profile: places to the right, numbers up, with a gap where there is none. */
@SuppressWarnings("serial") // never written to a stream
final class ProfileChart extends JPanel {

    /** What can be charted. */
    enum Content {
        /** The light, in three colours. */
        COLOUR("red", "green", "blue"),
        /** The Doppler factor. */
        DOPPLER("doppler_factor"),
        /** When the light started, in the scene frame. */
        TIME("hit_scene_time");

        private final List<String> columns;

        Content(String... columns) {
            this.columns = List.of(columns);
        }
    }

    private static final List<String> SWATCHES = List.of("#d94040", "#2f9e44", "#3b6fe0");
    private static final int MARGIN = 4;
    private static final int HEIGHT_IN_TYPES = 8;

    private transient Profile profile;
    private Content content = Content.COLOUR;

    ProfileChart() {
        setOpaque(false);
    }

    void show(Profile newProfile) {
        profile = newProfile;
        repaint();
    }

    void setContent(Content newContent) {
        content = newContent;
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(
                100, HEIGHT_IN_TYPES * UIManager.getFont("Label.font").getSize());
    }

    private double[] values(String column) {
        return profile.values(sighting -> number(sighting, column));
    }

    private static double number(Sighting sighting, String column) {
        return RayTable.column(column).value().apply(sighting) instanceof Double number ? number : Double.NaN;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        if (profile == null) {
            return;
        }
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Font font = UIManager.getFont("small.font");
        FontMetrics metrics = g.getFontMetrics(font);
        List<double[]> all = content.columns.stream().map(this::values).toList();
        double least = numbers(all).min().orElse(0);
        double largest = numbers(all).max().orElse(0);
        String bottom = Numbers.brief(least, 4);
        String top = Numbers.brief(largest, 4);
        int left = 2 * MARGIN + Math.max(metrics.stringWidth(bottom), metrics.stringWidth(top));
        Rectangle place = new Rectangle(left, MARGIN, getWidth() - left - MARGIN, getHeight() - 2 * MARGIN);
        g.setFont(font);
        g.setColor(UIManager.getColor("Label.foreground"));
        g.drawString(top, MARGIN, place.y + metrics.getAscent());
        g.drawString(bottom, MARGIN, place.y + place.height - metrics.getDescent());
        g.setColor(UIManager.getColor("Component.borderColor"));
        g.drawRect(place.x, place.y, place.width, place.height);
        g.setStroke(new BasicStroke(1.6f));
        for (int i = 0; i < all.size(); i++) {
            g.setColor(all.size() > 1 ? Color.decode(SWATCHES.get(i)) : UIManager.getColor("Component.accentColor"));
            g.draw(curve(all.get(i), least, largest, place));
        }
        g.dispose();
    }

    private static DoubleStream numbers(List<double[]> all) {
        return all.stream().flatMapToDouble(DoubleStream::of).filter(Double::isFinite);
    }

    private static Path2D curve(double[] values, double least, double largest, Rectangle place) {
        Path2D curve = new Path2D.Double();
        double range = largest > least ? largest - least : 1;
        boolean drawing = false;
        for (int i = 0; i < values.length; i++) {
            double x = place.x + place.width * (double) i / (values.length - 1);
            double y = place.y + place.height * (1 - (values[i] - least) / range);
            if (!Double.isFinite(values[i])) {
                drawing = false;
            } else if (drawing) {
                curve.lineTo(x, y);
            } else {
                curve.moveTo(x, y);
                drawing = true;
            }
        }
        return curve;
    }
}
