package tompkins.study;

import java.awt.Color;
import java.awt.Font;
import java.util.List;

/**
 * Colours and type of a chart.
 *
 * @param paper what it is drawn on
 * @param ink for words, numbers, axes and the first curve
 * @param grid fine lines through the numbers of the axes
 * @param size of the type of most words, in points
 */
public record ChartStyle(Color paper, Color ink, Color grid, float size) {

    private static final float PRINTED_SIZE = 12;

    // can be distinguished even by those who see few colours (Okabe and Ito 2008)
    private static final List<Color> HUES = List.of(
            new Color(0xe69f00),
            new Color(0x56b4e9),
            new Color(0x009e73),
            new Color(0x0072b2),
            new Color(0xd55e00),
            new Color(0xcc79a7),
            new Color(0x777777));

    /** For documents. */
    public static final ChartStyle PRINTED =
            new ChartStyle(Color.WHITE, Color.BLACK, new Color(0xdddddd), PRINTED_SIZE);

    /** For screens in dark rooms. */
    public static final ChartStyle DARK =
            new ChartStyle(new Color(0x1c1e21), new Color(0xe4e4e4), new Color(0x3d4147), PRINTED_SIZE);

    /** The same style with type of another size. */
    public ChartStyle withSize(float points) {
        return new ChartStyle(paper, ink, grid, points);
    }

    /** The colour of a curve, from 0 on; colours begin again after the last. */
    public Color curve(int number) {
        int hue = number % (HUES.size() + 1);
        return hue == 0 ? ink : HUES.get(hue - 1);
    }

    Font title() {
        return type(Font.BOLD, 4f / 3);
    }

    Font axis() {
        return type(Font.PLAIN, 13f / 12);
    }

    Font words() {
        return type(Font.PLAIN, 1);
    }

    /** For numbers along the axes, and notes in the chart. */
    Font numbers() {
        return type(Font.PLAIN, 5f / 6);
    }

    private Font type(int weight, float factor) {
        return new Font(Font.SANS_SERIF, weight, Math.round(factor * size));
    }
}
