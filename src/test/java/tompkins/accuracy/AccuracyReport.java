package tompkins.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.light.GoldenColours;
import tompkins.sceneobject.GoldenHits;
import tompkins.sceneobject.GoldenSolids;
import tompkins.sceneobject.HitMethod;
import tompkins.sceneobject.NaiveHits;
import tompkins.shutter.GoldenShutters;
import tompkins.spacetime.FrameMethod;
import tompkins.spacetime.FrameQuantity;
import tompkins.spacetime.NaiveFrames;
import tompkins.spacetime.Velocity;

/** The rows of the tables in docs/accuracy.md that hold measured numbers. */
final class AccuracyReport {

    private static final double U = GoldenTable.U;

    private AccuracyReport() {}

    static List<String> rows() {
        return Stream.of(
                        Comparison.all().stream().map(Comparison::row),
                        FailureMode.all().stream().map(FailureMode::row),
                        colours(),
                        pixelBudget())
                .flatMap(rows -> rows)
                .toList();
    }

    /** One line of the comparison with the reference data. */
    record Comparison(String quantity, String limit, Worst naive, Worst ours) {

        static List<Comparison> all() {
            List<Comparison> all = new ArrayList<>();
            for (FrameQuantity quantity : FrameQuantity.values()) {
                String name = quantity.name().toLowerCase(Locale.ROOT).replace('_', ' ');
                all.add(new Comparison(
                        name,
                        quantity.limit(),
                        quantity.worst(new NaiveFrames()),
                        quantity.worst(FrameMethod.PROGRAM)));
            }
            for (String model : List.of("detector_ideal", "fixed_point")) {
                all.add(new Comparison(
                        "shutter time, " + model.replace('_', ' '),
                        "4 u acond",
                        GoldenShutters.worstNaive(model),
                        GoldenShutters.worst(model)));
            }
            for (String shape : List.of("sphere", "plane", "cylinder")) {
                List<GoldenRow> rows = GoldenTable.rows(GoldenHits.FILE, row -> row.has("shape", shape));
                all.add(new Comparison(
                        "hit of a " + shape,
                        "4 u cond",
                        GoldenHits.worst(rows, new NaiveHits()),
                        GoldenHits.worst(rows, HitMethod.PROGRAM)));
            }
            for (String shape : List.of("cone", "box")) {
                List<GoldenRow> rows = GoldenTable.rows(GoldenSolids.FILE, row -> row.has("shape", shape));
                all.add(new Comparison(
                        "hit of a " + shape,
                        "u acond",
                        GoldenSolids.worstDistance(rows, new NaiveHits()),
                        GoldenSolids.worstDistance(rows, HitMethod.PROGRAM)));
            }
            all.add(new Comparison(
                    "normal of a cone",
                    "u acond",
                    GoldenSolids.worstNormal(new NaiveHits()),
                    GoldenSolids.worstNormal(HitMethod.PROGRAM)));
            return all;
        }

        String row() {
            return "| " + quantity + " | " + limit + " | " + ours.rows() + " | " + number(naive.excess()) + " | "
                    + number(ours.excess()) + " |";
        }
    }

    private static Stream<String> colours() {
        return Stream.of(new double[] {0.2, 0.5}, new double[] {0.5, 2}, new double[] {2, 1000})
                .map(range -> {
                    List<GoldenRow> rows = GoldenColours.rows(range[0], range[1]);
                    String words = String.format(Locale.ROOT, "%s to %s", range[0], range[1])
                            .replace(".0", "");
                    return "| " + words + " | " + number(GoldenColours.worstWhite(rows)) + " | "
                            + number(GoldenColours.worstPrimary(rows)) + " |";
                });
    }

    /** The parts of a pixel of the paper's camera: 640 pixels for 20 degrees. */
    private static Stream<String> pixelBudget() {
        double gamma = Velocity.of(0.2, -0.1, 0.97).gamma();
        double pixel = Math.toRadians(20) / 640;
        return Stream.of(
                "| direction in the scene at gamma 1e6, 8 gamma u | " + number(8e6 * U / pixel) + " pixels |",
                "| direction in the scene at this gamma, 8 gamma u | " + number(8 * gamma * U / pixel) + " pixels |",
                "| distance of a hit 10 away | " + number(40 * U) + " lengths |");
    }

    /** Two digits are enough, and as much as other machines repeat. */
    static String number(double value) {
        if (value == 0) {
            return "none";
        }
        return Double.isInfinite(value) || Double.isNaN(value)
                ? "no number"
                : String.format(Locale.ROOT, value >= 0.01 && value < 1000 ? "%.2g" : "%.1e", value);
    }
}
