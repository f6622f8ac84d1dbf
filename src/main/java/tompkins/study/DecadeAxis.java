package tompkins.study;

import java.awt.Graphics2D;
import java.awt.font.TextAttribute;
import java.awt.geom.Rectangle2D;
import java.text.AttributedString;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.LogTick;
import org.jfree.chart.axis.TickType;
import org.jfree.chart.axis.ValueTick;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;

/** A logarithmic axis with a number at each power of ten, and at multiples of it if there are few powers. */
final class DecadeAxis extends LogAxis {

    private static final long serialVersionUID = 1;
    private static final double FEW = 3;
    private static final int[] ALONE = {1};
    private static final int[] THREE = {1, 2, 5};
    private static final int[] NINE = {1, 2, 3, 4, 5, 6, 7, 8, 9};

    /**
     * An axis.
     *
     * @param label what it shows
     * @param values the values that are drawn, all above 0
     */
    DecadeAxis(String label, Stream<Double> values, ChartStyle style) {
        super(label);
        setLabelFont(style.axis());
        setLabelPaint(style.ink());
        setTickLabelFont(style.numbers());
        setTickLabelPaint(style.ink());
        // the default reaches below 0 if all values are smaller than 1e-8, and then the axis shows nothing
        values.min(Double::compare).ifPresent(least -> setAutoRangeMinimumSize(least / 2));
    }

    @Override
    public List<ValueTick> refreshTicks(Graphics2D g2, AxisState state, Rectangle2D dataArea, RectangleEdge edge) {
        double first = Math.log10(getLowerBound());
        double last = Math.log10(getUpperBound());
        int[] factors = last - first <= 1 ? NINE : last - first <= FEW ? THREE : ALONE;
        TextAnchor anchor = RectangleEdge.isTopOrBottom(edge) ? TextAnchor.TOP_CENTER : TextAnchor.CENTER_RIGHT;
        List<ValueTick> ticks = new ArrayList<>();
        for (int exponent = (int) Math.floor(first); exponent <= last; exponent++) {
            for (int factor : factors) {
                double value = factor * Math.pow(10, exponent);
                if (getRange().contains(value)) {
                    ticks.add(new LogTick(TickType.MAJOR, value, number(factor, exponent), anchor));
                }
            }
        }
        return ticks;
    }

    /** Such as 2·10⁻³. */
    private AttributedString number(int factor, int exponent) {
        String base = (factor == 1 ? "" : factor + "·") + "10";
        String text = base + exponent;
        AttributedString number = new AttributedString(text);
        number.addAttributes(getTickLabelFont().getAttributes(), 0, text.length());
        number.addAttribute(TextAttribute.SUPERSCRIPT, TextAttribute.SUPERSCRIPT_SUPER, base.length(), text.length());
        return number;
    }
}
