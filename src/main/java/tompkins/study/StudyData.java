package tompkins.study;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import tompkins.file.FileException;
import tompkins.file.OutputFolder;
import tompkins.file.PendingFile;

/**
 * The figures of a study in a file of comma-separated values: lines about the study, the program and the machine, then
 * one line for each measurement, written as soon as it is made. A study that was stopped goes on from there.
 */
public final class StudyData {

    /** How the name of a file ends if it holds a part of the figures. */
    private static final String PART = "-part-[0-9]*-of-[0-9]*.csv";

    private static final String COLUMNS = "problem,method,setting,rays,seconds_low,seconds_median,seconds_high,"
            + "error_low,error_median,error_high,maximum,reference_error";

    /** Is told how a study goes on. */
    @FunctionalInterface
    public interface Listener {

        /**
         * Another trial is done.
         *
         * @param measurement its result
         * @param done trials that are done, including those of earlier runs
         * @param all number of trials
         */
        void measured(Measurement measurement, int done, int all);
    }

    private final Path file;
    private final List<String> head;

    /**
     * The data of a study.
     *
     * @param kind which study it is
     * @param file where they are kept
     * @param program name and version of the program
     */
    public StudyData(StudyKind kind, Study study, Path file, String program) {
        this.file = file;
        head = List.of(
                "# study: " + kind,
                "# settings: " + study.settings(),
                "# program: " + program,
                "# machine: " + Machine.text(),
                COLUMNS);
    }

    /**
     * Makes the measurements of some trials of the study that the file does not hold yet, and returns all of them in
     * the order of the trials. Everything else in the file is replaced. What other processes have measured into the
     * files of {@link #PART} beside it is taken over, and these files are removed.
     */
    public List<Measurement> complete(List<Trial> trials, Listener listener) throws IOException {
        List<Path> parts = parts();
        List<Measurement> known = new ArrayList<>(read(file));
        for (Path part : parts) {
            known.addAll(read(part));
        }
        rewrite(known);
        List<Measurement> all = new ArrayList<>();
        for (Trial trial : trials) {
            Measurement measurement =
                    known.stream().filter(trial::made).findFirst().orElse(null);
            if (measurement == null) {
                measurement = trial.measure();
                append(line(measurement) + "\n");
            }
            all.add(measurement);
            listener.measured(measurement, all.size(), trials.size());
        }
        rewrite(all);
        for (Path part : parts) {
            Files.deleteIfExists(part);
        }
        return all;
    }

    /** The files of parts of the study beside the file, which hold what other processes have measured. */
    private List<Path> parts() throws IOException {
        Path folder = file.toAbsolutePath().getParent();
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        String pattern = file.getFileName().toString().replace(".csv", PART);
        List<Path> parts = new ArrayList<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, pattern)) {
            files.forEach(parts::add);
        }
        Collections.sort(parts);
        return parts;
    }

    /**
     * A file that is there, this one or that of a part, and holds something else: figures of another machine, program
     * or setting, or no figures; empty if there is none.
     */
    public Optional<Path> holdingOther() throws IOException {
        List<Path> files = new ArrayList<>(parts());
        files.add(0, file);
        for (Path each : files) {
            if (Files.exists(each) && !isOwn(lines(each))) {
                return Optional.of(each);
            }
        }
        return Optional.empty();
    }

    /** The complete lines; a measurement whose line was cut off when the program was stopped is made again. */
    private static List<String> lines(Path file) throws IOException {
        try {
            String text = Files.readString(file);
            return text.substring(0, text.lastIndexOf('\n') + 1).lines().toList();
        } catch (CharacterCodingException notText) {
            return List.of();
        }
    }

    private boolean isOwn(List<String> lines) {
        return lines.size() >= head.size() && lines.subList(0, head.size()).equals(head);
    }

    private List<Measurement> read(Path each) throws IOException {
        List<String> lines = Files.exists(each) ? lines(each) : List.of();
        return isOwn(lines)
                ? lines.stream()
                        .skip(head.size())
                        .map(line -> measurement(line, each))
                        .toList()
                : List.of();
    }

    private void rewrite(List<Measurement> measurements) throws IOException {
        Stream<String> lines =
                Stream.concat(head.stream(), measurements.stream().map(StudyData::line));
        OutputFolder folder = OutputFolder.at(file.toAbsolutePath().getParent());
        try {
            byte[] text = (String.join("\n", lines.toList()) + "\n").getBytes(StandardCharsets.UTF_8);
            PendingFile.save(file, true, out -> out.write(text));
        } finally {
            folder.close();
        }
    }

    private void append(String line) throws IOException {
        try {
            Files.writeString(file, line, StandardOpenOption.APPEND);
        } catch (IOException failure) {
            throw FileException.cannotWrite(file, failure);
        }
    }

    private static String line(Measurement point) {
        return String.format(
                Locale.ROOT,
                "%s,%s,%s,%s,%s,%s,%.6g,%.6g",
                quoted(point.problem()),
                quoted(point.method()),
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

    private static String quoted(String text) {
        return text.replace(',', ';');
    }

    private static String unquoted(String cell) {
        return cell.replace(';', ',');
    }

    private static Measurement measurement(String line, Path file) {
        String[] cells = line.split(",", -1);
        double[] numbers = new double[COLUMNS.split(",").length];
        try {
            for (int i = 2; i < numbers.length; i++) {
                numbers[i] = Double.parseDouble(cells[i]);
            }
        } catch (NumberFormatException | ArrayIndexOutOfBoundsException damaged) {
            throw new UncheckedIOException(
                    file + ": no figures of a study: " + line + "; without this line they are measured again",
                    new IOException(damaged));
        }
        return new Measurement(
                unquoted(cells[0]),
                unquoted(cells[1]),
                numbers[2],
                numbers[3],
                new Spread(numbers[4], numbers[5], numbers[6]),
                new Spread(numbers[7], numbers[8], numbers[9]),
                numbers[10],
                numbers[11]);
    }
}
