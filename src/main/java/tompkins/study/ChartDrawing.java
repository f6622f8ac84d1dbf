package tompkins.study;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import org.jfree.chart.ChartUtils;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.block.BlockBorder;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import tompkins.image.Palette;

/**
 * Draws a {@link Chart}: a curve with error bars for each method, its slope, the Pareto front, and the reference's
 * error.
 */
public final class ChartDrawing {

    private static final int WIDTH = 860;
    private static final int HEIGHT = 560;
    private static final int FEWEST_FOR_SLOPE = 3;
    private static final double RING = 6;
    private static final Color FRONT = new Color(255, 200, 0, 130);

    private ChartDrawing() {}

    /** The chart as a PNG file. */
    public static byte[] png(Chart chart, List<StudyPoint> all) {
        try {
            return ChartUtils.encodeAsPNG(
                    Palette.reduced(drawing(chart, all, ChartStyle.PRINTED)
                            .createBufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB, null)),
                    false,
                    9);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    /** The chart, drawn from those of the measurements that it shows. */
    public static JFreeChart drawing(Chart chart, List<StudyPoint> all, ChartStyle style) {
        List<StudyPoint> shown = chart.drawn(all);
        XYIntervalSeriesCollection curves = new XYIntervalSeriesCollection();
        XYErrorRenderer renderer = new XYErrorRenderer();
        renderer.setDefaultLinesVisible(true);
        renderer.setDrawXError(false);
        curves(chart, shown).forEach((name, points) -> addCurve(chart, name, points, curves, renderer, style));
        XYPlot plot = new XYPlot(
                curves,
                new DecadeAxis(chart.across().label(), shown.stream().map(chart::x), style),
                new DecadeAxis(
                        chart.up().label(),
                        shown.stream().map(point -> chart.y(point).low()),
                        style),
                renderer);
        plot.setBackgroundPaint(style.paper());
        plot.setDomainGridlinePaint(style.grid());
        plot.setRangeGridlinePaint(style.grid());
        if (chart.pareto()) {
            addFront(chart, shown, plot);
        }
        addFloor(shown, plot, style);
        JFreeChart drawing = new JFreeChart(chart.title(), style.title(), plot, true);
        drawing.getTitle().setPaint(style.ink());
        drawing.setBackgroundPaint(style.paper());
        drawing.getLegend().setPosition(RectangleEdge.RIGHT);
        drawing.getLegend().setFrame(BlockBorder.NONE);
        drawing.getLegend().setItemFont(style.words());
        drawing.getLegend().setItemPaint(style.ink());
        drawing.getLegend().setBackgroundPaint(style.paper());
        return drawing;
    }

    private static Map<String, List<StudyPoint>> curves(Chart chart, List<StudyPoint> shown) {
        Map<String, List<StudyPoint>> curves = new LinkedHashMap<>();
        // the first curve is drawn last, over the others
        if (shown.stream().anyMatch(point -> point.method().equals(chart.own()))) {
            curves.put(chart.own(), new ArrayList<>());
        }
        for (StudyPoint point : shown) {
            curves.computeIfAbsent(point.method(), method -> new ArrayList<>()).add(point);
        }
        curves.values()
                .forEach(points ->
                        points.sort(Comparator.comparingDouble(StudyPoint::rays).thenComparing(chart::x)));
        return curves;
    }

    private static void addCurve(
            Chart chart,
            String name,
            List<StudyPoint> points,
            XYIntervalSeriesCollection curves,
            XYErrorRenderer renderer,
            ChartStyle style) {
        int number = curves.getSeriesCount();
        XYIntervalSeries series = new XYIntervalSeries(name + slope(chart, points));
        // points of one curve at one place are drawn as one, with bars from the smallest to the largest
        Map<Double, List<Spread>> places = new TreeMap<>();
        for (StudyPoint point : points) {
            places.computeIfAbsent(chart.x(point), x -> new ArrayList<>()).add(chart.y(point));
        }
        places.forEach((x, values) -> {
            Spread middle =
                    Spread.of(values.stream().mapToDouble(Spread::middle).toArray());
            double low = values.stream().mapToDouble(Spread::low).min().orElseThrow();
            double high = values.stream().mapToDouble(Spread::high).max().orElseThrow();
            series.add(x, x, x, middle.middle(), low, high);
        });
        curves.addSeries(series);
        renderer.setSeriesPaint(number, style.curve(number));
        renderer.setSeriesStroke(number, new BasicStroke(1.6f));
        if (name.equals(chart.own())) {
            // a ring, so that a point of another method at the same place can be seen inside it
            renderer.setSeriesShape(number, new Ellipse2D.Double(-RING, -RING, 2 * RING, 2 * RING));
            renderer.setSeriesShapesFilled(number, false);
            renderer.setSeriesOutlineStroke(number, new BasicStroke(2));
        }
    }

    private static String slope(Chart chart, List<StudyPoint> points) {
        PowerLaw law = PowerLaw.fit(
                points.stream().mapToDouble(point -> chart.x(point)).toArray(),
                points.stream().mapToDouble(point -> chart.y(point).middle()).toArray());
        return points.size() < FEWEST_FOR_SLOPE || !Double.isFinite(law.slope())
                ? ""
                : StudyText.format("  (%.2f)", law.slope());
    }

    /** The points that no other beats on both axes, from the cheapest on. */
    static List<StudyPoint> front(Chart chart, List<StudyPoint> shown) {
        List<StudyPoint> byCost = new ArrayList<>(shown);
        byCost.sort(Comparator.comparing(chart::x)
                .thenComparing(point -> chart.y(point).middle()));
        List<StudyPoint> front = new ArrayList<>();
        double best = Double.POSITIVE_INFINITY;
        for (StudyPoint point : byCost) {
            double error = chart.y(point).middle();
            if (error < best) {
                best = error;
                front.add(point);
            }
        }
        return front;
    }

    /**
     * The measurement whose point is nearest to a place on a drawing; null if none is within reach.
     *
     * @param area where the drawing has its curves, in pixels
     * @param place in pixels
     * @param reach in pixels
     */
    public static StudyPoint nearest(
            Chart chart, List<StudyPoint> all, XYPlot plot, Rectangle2D area, Point2D place, double reach) {
        ToDoubleFunction<StudyPoint> distance = point -> place.distance(
                plot.getDomainAxis().valueToJava2D(chart.x(point), area, plot.getDomainAxisEdge()),
                plot.getRangeAxis().valueToJava2D(chart.y(point).middle(), area, plot.getRangeAxisEdge()));
        return chart.drawn(all).stream()
                .filter(point -> distance.applyAsDouble(point) <= reach)
                .min(Comparator.comparingDouble(distance))
                .orElse(null);
    }

    private static void addFront(Chart chart, List<StudyPoint> shown, XYPlot plot) {
        XYSeries series = new XYSeries("Pareto front", false);
        front(chart, shown)
                .forEach(point -> series.add(chart.x(point), chart.y(point).middle()));
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, false);
        renderer.setSeriesPaint(0, FRONT);
        renderer.setSeriesStroke(0, new BasicStroke(9, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        plot.setDataset(1, new XYSeriesCollection(series));
        plot.setRenderer(1, renderer);
    }

    private static void addFloor(List<StudyPoint> shown, XYPlot plot, ChartStyle style) {
        double floor = shown.stream().mapToDouble(StudyPoint::floor).max().orElse(0);
        if (floor > 0) {
            ValueMarker marker = new ValueMarker(floor, Color.GRAY, new BasicStroke(1.5f));
            marker.setLabel("error of the reference");
            marker.setLabelFont(style.numbers());
            marker.setLabelPaint(style.ink());
            marker.setLabelAnchor(RectangleAnchor.TOP_LEFT);
            marker.setLabelTextAnchor(TextAnchor.BOTTOM_LEFT);
            plot.addRangeMarker(marker);
        }
    }
}
