package tompkins.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
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

/** The page docs/accuracy.md, with all numbers measured while it is written. */
final class AccuracyReport {

    static final String COMMAND = "mvn -q test -Dtest=AccuracyReportTest -Dtompkins.regenerate=true";

    private static final double U = GoldenTable.U;

    private final StringBuilder text = new StringBuilder();

    static String markdown() {
        AccuracyReport report = new AccuracyReport();
        report.introduction();
        report.referenceTable();
        report.failureModes();
        report.colours();
        report.pixelBudget();
        report.limits();
        report.commands();
        return report.text.toString();
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
                var rows = GoldenTable.rows(GoldenHits.FILE, row -> row.has("shape", shape));
                all.add(new Comparison(
                        "hit of a " + shape,
                        "4 u cond",
                        GoldenHits.worst(rows, new NaiveHits()),
                        GoldenHits.worst(rows, HitMethod.PROGRAM)));
            }
            for (String shape : List.of("cone", "box")) {
                var rows = GoldenTable.rows(GoldenSolids.FILE, row -> row.has("shape", shape));
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
    }

    private void introduction() {
        line("# Accuracy");
        line("");
        line("Written by `" + COMMAND + "`; a test fails when its numbers no longer hold.");
        line("");
        line("All numbers are doubles; u = 2^-53 = 1.1e-16 is the relative error of one rounding. Units have c = 1.");
        line("*Textbook* is the usual formula, as in textbooks and the paper, kept in the test sources as `Naive...`.");
        line("Errors are relative unless the line says otherwise; *none* means that not one digit differs from the");
        line("reference, *no number* that the form gives infinity or NaN. [Conventions](conventions.md) says");
        line(
                "what the quantities mean, [Speed and accuracy](speed-and-accuracy.md) what more samples gain, and [Limits](limits.md)");
        line("what is refused.");
        line("");
    }

    private void referenceTable() {
        line("## Against reference data");
        line("");
        line(
                "Reference numbers, computed with 80 digits by another program (`src/test/resources/golden`): the worst row, as a");
        line("multiple of the limit that the row allows. A method passes with 1 or less. In the limits");
        line("- gamma is the Lorentz factor of the camera, gamma_w that of the window before it;");
        line(
                "- acond = |f| + sum of |x df/dx| over the inputs x of the result f: how far f moves when each input changes by a");
        line(
                "  relative 1, so that u acond is what rounding the inputs alone may cost; |f| of a vector is its length;");
        line("- cond is the same for the distance of a hit, divided by that distance.");
        line("");
        line("| quantity | limit | rows | textbook | Tompkins |");
        line("|---|---|---|---|---|");
        for (Comparison comparison : Comparison.all()) {
            line("| " + comparison.quantity() + " | " + comparison.limit() + " | "
                    + comparison.ours().rows() + " | "
                    + number(comparison.naive().excess()) + " | "
                    + number(comparison.ours().excess()) + " |");
        }
        line("");
    }

    private void failureModes() {
        line("## Where textbook formulas fail");
        line("");
        line("| quantity and textbook formula | where | error of the textbook | error of Tompkins |");
        line("|---|---|---|---|");
        for (FailureMode mode : FailureMode.all()) {
            line("| " + mode.quantity() + " | " + mode.where() + " | " + number(mode.naive()) + " | "
                    + number(mode.ours()) + " |");
        }
        line("");
    }

    private void colours() {
        line("## Colours under a Doppler shift");
        line("");
        line("How far the colours of the [model](conventions.md#colours) are from its integrals over the wavelength,");
        line(
                "which another program computed in steps of 0.1 nm with the CIE 1931 functions between their tabulated values.");
        line("The error of a colour is that of its worst channel, as a fraction of its brightest channel:");
        line("so a nearly black colour counts as much as a bright one. Red, green and blue are those of the screen.");
        line("");
        line("| D | white | red, green, blue |");
        line("|---|---|---|");
        for (ColourRange range : ColourRange.values()) {
            line("| " + range.words + " | "
                    + number(GoldenColours.worstWhite(range.rows())) + " | "
                    + number(GoldenColours.worstPrimary(range.rows())) + " |");
        }
        line("");
    }

    /** Doppler factors, in ranges. */
    private enum ColourRange {
        LOW("0.2 to 0.5", 0.2, 0.5),
        MIDDLE("0.5 to 2", 0.5, 2),
        HIGH("2 to 1000", 2, 1000);

        private final String words;
        private final double least;
        private final double most;

        ColourRange(String words, double least, double most) {
            this.words = words;
            this.least = least;
            this.most = most;
        }

        List<GoldenRow> rows() {
            return GoldenColours.rows(least, most);
        }
    }

    private void pixelBudget() {
        double gamma = Velocity.of(0.2, -0.1, 0.97).gamma();
        double pixel = Math.toRadians(20) / 640;
        line("## Error budget of a pixel");
        line("");
        line("For the paper's camera: 640 pixels for 20 degrees, velocity (0.2, -0.1, 0.97), so gamma is "
                + String.format(Locale.ROOT, "%.2f", gamma) + " and a pixel");
        line(String.format(
                Locale.ROOT,
                "sees %.2g radians. Largest first, where a part of a pixel counts as that part of full scale:",
                pixel));
        line("");
        line("| source | size |");
        line("|---|---|");
        line("| an edge through the pixel, one sample | 0.5 of full scale |");
        line("| the same with n samples spread evenly | falls as n^(-3/4) |");
        line("| 8 bits, the linear tone curve rounds down | " + number(1.0 / 255) + " of full scale |");
        line("| 8 bits, the sRGB tone curve rounds to the nearest level | half a step |");
        line("| light given up below 1/1024 of the sample | " + number(1.0 / 1024) + " of the brightest source |");
        line("| direction in the scene at gamma 1e6, 8 gamma u | " + number(8e6 * U / pixel) + " pixels |");
        line("| sums of samples in single precision | " + number(0x1p-24) + " of the value, for each pass |");
        line("| direction in the scene at this gamma, 8 gamma u | " + number(8 * gamma * U / pixel) + " pixels |");
        line("| distance of a hit 10 away | " + number(40 * U) + " lengths |");
        line("");
    }

    private void limits() {
        line("## What double precision can and cannot do");
        line("");
        line(
                "- Up to gamma = 1e6 directions are right to 8 gamma u radians, 1e-9. Scene files may say a gamma up to 1e8;");
        line("  above 1e6 `check`, `explain` and `render` warn, and say how wrong directions may be.");
        line("- A velocity in decimals is less precise than it looks: rounding its components changes gamma by");
        line("  gamma^2 u; at gamma = 1e8 nothing is left of it. Write `gamma`, `rapidity` or `oneMinusBeta` instead.");
        line(
                "- An event that lies on the light cone of the origin loses gamma^2 u when it is taken to another frame and");
        line("  back: the other frame's coordinates are that much larger. Nothing helps, so each ray crosses once.");
        line("- A camera far from the origin sees objects beside it as sharply as at the origin, if their coordinates");
        line("  say where they are: near 1e12 neighbouring doubles are 1.2e-4 apart.");
        line(
                "- Whether a ray that grazes an object hits it is open within some u of the ray's length; so is whether light");
        line("  is totally reflected within u of the critical angle, where nothing is transmitted anyway.");
        line(
                "- Tiles alternate up to 2^53 of them from the start of the coordinates; beyond, and wherever a pixel sees very");
        line(
                "  many, a filtered tiling is the mean of its surfaces. The filter takes boxes along the spot of a ray on the");
        line(
                "  surface: with one sample, pixels that see one or two tiles are wrong by some hundredths of the contrast. The");
        line("  spot is that of the part of the pixel for which a sample stands, so that more samples are less wrong.");
        line(
                "- A filtered picture is interpolated between mip maps, whose pixels overlap by half of their width: with one sample");
        line("  it is softer than the mean over the pixel, by about half a pixel. The mean light is kept.");
        line(
                "- A point in focus at infinity has no time for a shutter on the focus surface, and a ray parallel to the plane");
        line("  of a shutter never crosses it: such samples stay black and are counted.");
        line("");
    }

    private void commands() {
        line("## How it is tested");
        line("");
        line("| what | command |");
        line("|---|---|");
        line("| reference data, closed forms, failure modes | `mvn test` |");
        line("| 10 000 random studios | `mvn test -Dtest=StudioFuzzTest -Dtompkins.fuzz=10000` |");
        line("| 1000 cancelled renders | `mvn test -Dtest=SoakTest -Dtompkins.soak=1000` |");
    }

    private void line(String line) {
        text.append(line).append('\n');
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
