package tompkins.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The commands with which POV-Ray 3.7 takes the two figures of the paper that it can take. */
final class PovRay {

    private static final Path SCENE = Path.of("src/bench/povray/figure.pov");
    private static final Path PICTURE = Path.of("target/povray.png");
    private static final Pattern RENDERING = Pattern.compile("Trace Time:[^(]*\\(([0-9.]+) seconds\\)");
    private static final Pattern VERSION = Pattern.compile("POV-Ray ([0-9.]*[0-9])");

    /** Why nothing can be compared. */
    static final String MISSING = "POV-Ray is not installed (apt-get install povray)";

    /** What stands for white in {@link #SCENE}. */
    private static final double EXPOSURE = 0.4;

    /** Rows of its jittered grids of samples in a pixel: the fewest that are tried, and the most that it knows. */
    private static final int LEAST_GRID = 2;

    private static final int MOST_GRID = 9;

    /** Differences at which it divides a pixel, and how often it does at most. */
    private static final double[] DIFFERENCES = {0.3, 0.1, 0.03, 0.01};

    private static final int LEAST_DEPTH = 3;
    private static final int MOST_DEPTH = 5;

    /** Plain pictures are at most so many times as wide and as high. */
    private static final int MOST_TIMES = 8;

    private static final int TIMES_OF_REFERENCE = 4;
    private static final int GRID_OF_REFERENCE = 5;

    /**
     * Its options for the figures that it can take; Fig. 1(b) as the same view of a scene at rest, without any change
     * of frame.
     */
    static final Map<String, List<String>> OPTIONS = Map.of("fig1a", List.of(), "fig1b", List.of("Declare=Moving=1"));

    private final String figure;
    private final int width;

    PovRay(String figure, int width) {
        this.figure = figure;
        this.width = width;
    }

    /** The version; null if there is no POV-Ray here. */
    static String version() throws InterruptedException {
        try {
            Process process = new ProcessBuilder("povray", "--version")
                    .redirectErrorStream(true)
                    .start();
            Matcher version =
                    VERSION.matcher(new String(process.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1));
            process.waitFor();
            return version.find() ? version.group(1) : null;
        } catch (IOException notInstalled) {
            return null;
        }
    }

    /** Many samples, with which the others are compared. */
    PictureCommand reference() {
        return grid(TIMES_OF_REFERENCE, GRID_OF_REFERENCE);
    }

    /** All settings that are tried. */
    List<PictureCommand> settings() {
        List<PictureCommand> settings = new ArrayList<>();
        for (int rows = LEAST_GRID; rows <= MOST_GRID; rows++) {
            settings.add(grid(1, rows));
        }
        for (double difference : DIFFERENCES) {
            for (int depth = LEAST_DEPTH; depth <= MOST_DEPTH; depth++) {
                settings.add(command(1, "+AM2", "+A" + difference, "+R" + depth));
            }
        }
        for (int times = 2; times <= MOST_TIMES; times++) {
            settings.add(command(times, "-A"));
        }
        return settings;
    }

    /** More samples where neighbours differ at all. */
    private PictureCommand grid(int times, int rows) {
        return command(times, "+AM1", "+A0.0", "+R" + rows);
    }

    private PictureCommand command(int times, String... antialiasing) {
        List<String> command = new ArrayList<>(List.of(
                "povray",
                "+I" + SCENE,
                "+W" + times * width,
                "+H" + times * width * 3 / 4,
                "-D",
                "+WT2",
                "+BM2",
                "+FN16",
                "File_Gamma=1.0",
                "+O" + PICTURE));
        command.addAll(OPTIONS.get(figure));
        command.addAll(List.of(antialiasing));
        String setting = Arrays.stream(antialiasing)
                .filter(option -> !option.equals("-A") && !option.equals("+A0.0"))
                .map(option -> option.substring(1))
                .collect(Collectors.joining(" "));
        return new PictureCommand(
                ((times > 1 ? times + "x " : "") + setting).strip(), command, RENDERING, PICTURE, times, EXPOSURE);
    }
}
