package tompkins.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tompkins.ui.RideBenchmark;

/** How live rides are in the window: through Fig. 1(b), the scenes with motion, and the first scene of the program. */
final class RideInWindow {

    private static final Path SCENES = Path.of("scenes");
    private static final String HEAD = """

            ## Rides

            In the window, at 826 x 620 pixels. The difference is the root mean square, of 255 levels, to a picture with a sample in each pixel.

            """;
    private static final String FIRST = SCENES.resolve("town-square.json").toString();

    private RideInWindow() {}

    /** What people notice of a ride, as the benchmark prints it. */
    private enum Column {
        PICTURES("pictures in a second", 30, Double.POSITIVE_INFINITY),
        THRUST("thrust to a picture on the screen, ms", 0, 50),
        DIFFERENCE("difference to the whole picture, levels", 0, 4),
        WORST("in the worst second", 0, 8);

        private final String heading;
        private final double least;
        private final double most;

        Column(String heading, double least, double most) {
            this.heading = heading;
            this.least = least;
            this.most = most;
        }

        private String target() {
            return least > 0 ? "at least " + Measure.number(least) : "at most " + Measure.number(most);
        }

        /** A number as it stands in the table: bold where it misses its target. */
        private String cell(double value) {
            String number = Measure.number(value);
            return value >= least && value <= most ? number : "**" + number + "**";
        }
    }

    /**
     * Rides through all of them in one process.
     *
     * @param thrusts how often there is thrust in each scene
     * @return a table of the medians of each, as Markdown
     */
    static String measure(int thrusts) throws IOException, InterruptedException {
        if (!Window.isPossible()) {
            return "\n## Rides\n\n" + Window.NO_DISPLAY + "\n";
        }
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                RideBenchmark.class.getName(),
                Integer.toString(thrusts),
                SCENES.resolve("fig1b.json").toString()));
        try (Stream<Path> files = Files.list(SCENES)) {
            files.filter(file -> file.getFileName().toString().startsWith("motion-"))
                    .sorted()
                    .forEach(file -> command.add(file.toString()));
        }
        command.addAll(List.of(FIRST, RideBenchmark.BESIDE_REST, FIRST));
        Process process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        StringBuilder table = new StringBuilder(HEAD)
                .append(row("ride", column -> column.heading))
                .append(row("---", column -> "---"))
                .append(row("target", Column::target));
        try (BufferedReader lines = process.inputReader()) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                int colon = line.indexOf(": ");
                String[] values = line.substring(colon + 2).split(" ");
                table.append(row(
                        line.substring(0, colon), column -> column.cell(Double.parseDouble(values[column.ordinal()]))));
            }
        }
        if (process.waitFor() != 0) {
            throw new IOException("the window ended with exit code " + process.exitValue());
        }
        return table.toString();
    }

    private static String row(String ride, Function<Column, String> cell) {
        return "| " + ride + " | " + Stream.of(Column.values()).map(cell).collect(Collectors.joining(" | ")) + " |\n";
    }
}
