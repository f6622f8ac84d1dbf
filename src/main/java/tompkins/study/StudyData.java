package tompkins.study;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import tompkins.file.PendingFile;

/**
 * The figures of a study, and where they come from: a file of comma-separated values, with lines about the study, the
 * program and the machine at its top, then one line for each measurement.
 *
 * @param origin which study with which settings was made by which program on which machine
 * @param measurements those of all trials of the study, in their order
 */
public record StudyData(Origin origin, List<StudyPoint> measurements) {

    private static final String COLUMNS = "problem,method,setting,rays,seconds_low,seconds_median,seconds_high,"
            + "error_low,error_median,error_high,maximum,reference_error";

    /**
     * Where figures come from.
     *
     * @param study the name of the study
     * @param settings see {@link Study#settings()}
     * @param program name and version of the program
     * @param machine processor, cores, system and Java
     */
    public record Origin(String study, String settings, String program, String machine) {

        /** What is measured here, by this program, now. */
        public static Origin here(StudyKind kind, Study study, String program) {
            return new Origin(kind.toString(), study.settings(), program, machineHere());
        }

        private static String machineHere() {
            return processor() + ", " + Runtime.getRuntime().availableProcessors() + " cores, "
                    + System.getProperty("os.name") + " " + System.getProperty("os.arch") + ", Java "
                    + System.getProperty("java.version");
        }

        private static String processor() {
            try (Stream<String> lines = Files.lines(Path.of("/proc/cpuinfo"))) {
                return lines.filter(line -> line.startsWith("model name"))
                        .findFirst()
                        .map(StudyData::value)
                        .orElse("processor");
            } catch (IOException unreadable) {
                return "processor";
            }
        }

        private List<String> head() {
            return List.of(
                    "# study: " + study,
                    "# settings: " + settings,
                    "# program: " + program,
                    "# machine: " + machine,
                    COLUMNS);
        }
    }

    /**
     * Reads a file.
     *
     * @return empty if it does not hold the figures of a study
     * @throws IOException if it cannot be read
     * @throws UncheckedIOException if a line of it is damaged
     */
    public static Optional<StudyData> read(Path file) throws IOException {
        List<String> lines;
        try {
            lines = Files.readAllLines(file);
        } catch (CharacterCodingException notText) {
            return Optional.empty();
        }
        if (lines.indexOf(COLUMNS) != 4) {
            return Optional.empty();
        }
        Origin origin = new Origin(value(lines.get(0)), value(lines.get(1)), value(lines.get(2)), value(lines.get(3)));
        return Optional.of(new StudyData(
                origin,
                lines.stream().skip(5).map(line -> measurement(line, file)).toList()));
    }

    /** What stands behind the colon of a line about the study. */
    private static String value(String line) {
        return line.substring(line.indexOf(": ") + 2);
    }

    /** Writes the file, in place of one that is there. */
    public void write(Path file) throws IOException {
        Stream<String> lines =
                Stream.concat(origin.head().stream(), measurements.stream().map(StudyData::line));
        byte[] text = (String.join("\n", lines.toList()) + "\n").getBytes(StandardCharsets.UTF_8);
        PendingFile.save(file, true, out -> out.write(text));
    }

    private static String line(StudyPoint point) {
        return String.format(
                Locale.ROOT,
                "%s,%s,%s,%s,%s,%s,%.6g,%.6g",
                point.problem(),
                point.method(),
                point.setting(),
                point.rays(),
                line(point.seconds()),
                line(point.error()),
                point.maximum(),
                point.floor());
    }

    private static String line(Spread spread) {
        return String.format(Locale.ROOT, "%.6g,%.6g,%.6g", spread.low(), spread.middle(), spread.high());
    }

    private static StudyPoint measurement(String line, Path file) {
        String[] cells = line.split(",", -1);
        double[] numbers = new double[COLUMNS.split(",").length];
        try {
            for (int i = 2; i < numbers.length; i++) {
                numbers[i] = Double.parseDouble(cells[i]);
            }
        } catch (NumberFormatException | ArrayIndexOutOfBoundsException damaged) {
            throw new UncheckedIOException(
                    file + ": no figures of a study: " + line + "; without the file they are measured again",
                    new IOException(damaged));
        }
        return new StudyPoint(
                cells[0],
                cells[1],
                numbers[2],
                numbers[3],
                new Spread(numbers[4], numbers[5], numbers[6]),
                new Spread(numbers[7], numbers[8], numbers[9]),
                numbers[10],
                numbers[11]);
    }
}
