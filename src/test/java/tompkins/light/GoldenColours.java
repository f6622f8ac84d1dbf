package tompkins.light;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.ray.Colour;

/** Compares what becomes of colours under the Doppler shift with the reference data. */
public final class GoldenColours {

    private static final List<String> CHANNELS = List.of("r", "g", "b");

    private GoldenColours() {}

    /** All rows with a Doppler factor from one number to another. */
    public static List<GoldenRow> rows(double least, double most) {
        return GoldenTable.rows("i_doppler_colours", row -> row.number("d") >= least && row.number("d") <= most);
    }

    /** The error of white in the worst row, in the unit of {@link #error}. */
    public static double worstWhite(List<GoldenRow> rows) {
        return rows.stream()
                .mapToDouble(row -> error(row, "red", "green", "blue"))
                .max()
                .orElseThrow();
    }

    /** The error of red, green and blue, whichever is worst, in the worst row. */
    public static double worstPrimary(List<GoldenRow> rows) {
        return rows.stream()
                .flatMapToDouble(row -> Stream.of("red", "green", "blue").mapToDouble(colour -> error(row, colour)))
                .max()
                .orElseThrow();
    }

    /**
     * By how much the channels of a colour are wrong, the worst of them, as a share of the brightest channel that is
     * seen of it.
     *
     * @param primaries the screen's primaries whose sum the colour is
     */
    private static double error(GoldenRow row, String... primaries) {
        double[] expected = CHANNELS.stream()
                .mapToDouble(channel -> Math.max(
                        0,
                        Stream.of(primaries)
                                .mapToDouble(primary -> row.number(primary + "_" + channel))
                                .sum()))
                .toArray();
        Colour seen = ColourLaw.DOPPLER.seen(colour(List.of(primaries)), row.number("d"));
        double[] found = {seen.red(), seen.green(), seen.blue()};
        double most = 0;
        for (int i = 0; i < found.length; i++) {
            most = Math.max(most, Math.abs(found[i] - expected[i]));
        }
        return most / DoubleStream.of(expected).max().orElseThrow();
    }

    private static Colour colour(List<String> primaries) {
        return new Colour(
                primaries.contains("red") ? 1 : 0,
                primaries.contains("green") ? 1 : 0,
                primaries.contains("blue") ? 1 : 0);
    }
}
