package tompkins.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.axis.ValueTick;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.RectangleEdge;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Charts can be read: points within the axes, numbers beside them, and the program's own points over the others. */
class ChartDrawingTest {

    private static final String OWN = "the program";
    private static final double MOST_ROOM = 100;
    private static final int FIRST_COLOUR = 0xff000000;
    private static final int SECOND_COLOUR = 0xffe69f00;

    /** A chart shows its points, on axes that are not much longer than they need and have numbers. */
    static void assertReadable(Chart chart, List<StudyPoint> all) {
        assertThat(all)
                .filteredOn(point -> point.problem().startsWith(chart.problem()))
                .allMatch(point -> chart.x(point) > 0);
        List<StudyPoint> drawn = chart.drawn(all);
        XYPlot plot = ChartDrawing.drawing(chart, all, ChartStyle.PRINTED).getXYPlot();
        assertSpans(plot.getDomainAxis(), drawn.stream().mapToDouble(chart::x));
        assertSpans(
                plot.getRangeAxis(),
                drawn.stream()
                        .map(chart.up().value())
                        .flatMapToDouble(spread -> DoubleStream.of(spread.low(), spread.high())));
    }

    private static void assertSpans(ValueAxis axis, DoubleStream values) {
        DoubleSummaryStatistics span = values.summaryStatistics();
        assertThat(axis.getLowerBound())
                .as(axis.getLabel())
                .isLessThan(span.getMin())
                .isGreaterThan(span.getMin() / MOST_ROOM);
        assertThat(axis.getUpperBound())
                .as(axis.getLabel())
                .isGreaterThan(span.getMax())
                .isLessThan(span.getMax() * MOST_ROOM);
        assertThat(numbers(axis)).as(axis.getLabel()).hasSizeGreaterThan(1);
    }

    private static List<Double> numbers(ValueAxis axis) {
        return ((DecadeAxis) axis)
                .refreshTicks(null, null, null, RectangleEdge.LEFT).stream()
                        .map(ValueTick::getValue)
                        .toList();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-9, 1e-16, 1e12})
    void pointsOfAnySizeAreShown(double size) {
        assertReadable(chart(), List.of(point(OWN, 1, size), point(OWN, 50, 30 * size)));
    }

    @Test
    void lessThanADecadeHasNumbers() {
        XYPlot plot = ChartDrawing.drawing(
                        chart(), List.of(point(OWN, 1, 0.11), point(OWN, 2, 0.38)), ChartStyle.PRINTED)
                .getXYPlot();
        assertThat(numbers(plot.getRangeAxis()).stream().map(Double::floatValue))
                .containsExactly(0.2f, 0.3f, 0.4f);
    }

    @Test
    void fewDecadesHaveNumbersWithin() {
        XYPlot plot = ChartDrawing.drawing(
                        chart(), List.of(point(OWN, 1.5, 1e-6), point(OWN, 25, 1)), ChartStyle.PRINTED)
                .getXYPlot();
        assertThat(numbers(plot.getDomainAxis())).containsExactly(2.0, 5.0, 10.0, 20.0);
        assertThat(numbers(plot.getRangeAxis())).hasSize(7).allMatch(value -> Math.log10(value) % 1 == 0);
    }

    @Test
    void ownPointIsSeenOverAnotherAtTheSamePlace() {
        List<StudyPoint> all = List.of(
                point("other", 1, 0.1), point("other", 10, 0.01), point(OWN, 10, 0.01), point("other", 100, 0.001));
        assertThat(pixels(SECOND_COLOUR, chart(), all)).as("covered").isZero();
        assertThat(pixels(FIRST_COLOUR, chart(OWN), all)).as("ring").isBetween(20L, 150L);
        assertThat(pixels(SECOND_COLOUR, chart(OWN), all)).isGreaterThan(100);
    }

    /** Number of pixels of a colour between the axes. */
    private static long pixels(int colour, Chart chart, List<StudyPoint> all) {
        JFreeChart drawing = ChartDrawing.drawing(chart, all, ChartStyle.PRINTED);
        drawing.removeLegend();
        BufferedImage image = drawing.createBufferedImage(600, 400);
        return IntStream.range(0, 600 * 400)
                .filter(place -> place % 600 > 100 && place / 600 < 340 && place / 600 > 40)
                .filter(place -> image.getRGB(place % 600, place / 600) == colour)
                .count();
    }

    private static Chart chart() {
        return chart("");
    }

    private static Chart chart(String own) {
        return new Chart("p", "title", Chart.setting("setting"), Chart.ERROR, false, own);
    }

    private static StudyPoint point(String method, double setting, double error) {
        return new StudyPoint("p", method, setting, 1, Spread.exact(1), Spread.exact(error), error, 0);
    }
}
