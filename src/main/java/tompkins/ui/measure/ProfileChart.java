package tompkins.ui.measure;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.util.List;
import javax.swing.UIManager;
import org.jfree.chart.ChartPanel;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.Range;
import org.jfree.data.general.DatasetUtils;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import tompkins.measure.RayTable;
import tompkins.measure.Sighting;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

/** A small chart of columns of a profile: places to the right, numbers up, with a gap where there is none. */
@SuppressWarnings("serial") // never written to a stream
final class ProfileChart extends ChartPanel {

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

    private static final List<Color> COLOURS = List.of(new Color(0xd94040), new Color(0x2f9e44), new Color(0x3b6fe0));
    private static final int HEIGHT_IN_TYPES = 11;

    /** Room above the highest number, as a part of all. */
    private static final double ABOVE = 0.06;

    /** The least range of numbers, as a part of themselves: fewer digits tell them apart. */
    private static final double LEAST_RANGE = 1e-4;

    /** Half of the width of a number, in sizes of the type. */
    private static final double HALF_NUMBER = 1.8;

    private transient List<Sighting> profile;
    private Content content = Content.COLOUR;

    /** An empty chart. */
    ProfileChart() {
        super(null);
        // its own menu saves without asking whether to overwrite, and a drag would zoom away from the curves
        setPopupMenu(null);
        setMouseZoomable(false);
        // or it would be drawn in another size, and stretched
        setMinimumDrawWidth(1);
        setMinimumDrawHeight(1);
        setMaximumDrawWidth(Integer.MAX_VALUE);
        setMaximumDrawHeight(Integer.MAX_VALUE);
        setOpaque(false);
    }

    void show(List<Sighting> newProfile) {
        profile = newProfile;
        draw();
    }

    void setContent(Content newContent) {
        content = newContent;
        draw();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(
                100, HEIGHT_IN_TYPES * UIManager.getFont("Label.font").getSize());
    }

    /** Follows the look. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (profile != null) {
            draw();
        }
    }

    private void draw() {
        setChart(profile == null ? null : drawing());
    }

    private JFreeChart drawing() {
        XYSeriesCollection curves = new XYSeriesCollection();
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, false);
        renderer.setDefaultStroke(new BasicStroke(1.6f));
        renderer.setAutoPopulateSeriesStroke(false);
        for (String column : content.columns) {
            int number = curves.getSeriesCount();
            curves.addSeries(curve(column));
            renderer.setSeriesPaint(
                    number,
                    content.columns.size() > 1 ? COLOURS.get(number) : UIManager.getColor("Component.accentColor"));
        }
        NumberAxis up = axis(null);
        up.setAutoRangeIncludesZero(false);
        up.setUpperMargin(ABOVE);
        Range values = DatasetUtils.findRangeBounds(curves);
        if (values != null && values.getCentralValue() != 0) {
            up.setAutoRangeMinimumSize(LEAST_RANGE * Math.abs(values.getCentralValue()));
        }
        XYPlot plot = new XYPlot(curves, axis(Texts.get("measure.alongLine")), up, renderer);
        plot.setBackgroundPaint(UIManager.getColor("TextField.background"));
        plot.setDomainGridlinePaint(UIManager.getColor("Component.borderColor"));
        plot.setRangeGridlinePaint(UIManager.getColor("Component.borderColor"));
        plot.setOutlinePaint(UIManager.getColor("Component.borderColor"));
        // half of a number stands to the right of its place
        plot.setInsets(new RectangleInsets(4, 0, 0, Look.pixels(HALF_NUMBER)));
        JFreeChart drawing = new JFreeChart(null, null, plot, false);
        drawing.setBackgroundPaint(null);
        drawing.setPadding(RectangleInsets.ZERO_INSETS);
        return drawing;
    }

    private static NumberAxis axis(String label) {
        NumberAxis axis = new NumberAxis(label);
        axis.setStandardTickUnits(NumberAxis.createStandardTickUnits());
        Font font = UIManager.getFont("small.font");
        Color ink = UIManager.getColor("Label.foreground");
        axis.setLabelFont(font);
        axis.setTickLabelFont(font);
        axis.setLabelPaint(ink);
        axis.setTickLabelPaint(ink);
        axis.setAxisLinePaint(ink);
        axis.setLowerMargin(0);
        axis.setUpperMargin(0);
        axis.setLabelInsets(RectangleInsets.ZERO_INSETS);
        return axis;
    }

    /** Numbers over the distance from the first place in pixels. */
    private XYSeries curve(String column) {
        XYSeries curve = new XYSeries(column, false);
        Sighting first = profile.get(0);
        for (Sighting place : profile) {
            double number = RayTable.number(place, column);
            curve.add(
                    Math.hypot(place.x() - first.x(), place.y() - first.y()),
                    Double.isFinite(number) ? number : Double.NaN);
        }
        return curve;
    }
}
