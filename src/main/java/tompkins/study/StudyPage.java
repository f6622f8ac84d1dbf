package tompkins.study;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import tompkins.file.PendingFile;
import tompkins.ray.Ray;
import tompkins.render.Quality;
import tompkins.search.ObjectTree;

/**
 * A page in Markdown with the charts of studies, what follows from them, and whether they meet their demands, beside a
 * folder with their files.
 */
public final class StudyPage {

    private final Path folder;
    private final String name;
    private final StringBuilder text = new StringBuilder();

    /** The files that were there before and may be replaced: they come from an earlier run, or the user allowed it. */
    private final Set<Path> earlier = new HashSet<>();

    /**
     * A page that will be {@code folder/name.md}, with its charts and data in {@code folder/name}.
     *
     * @param introduction Markdown for the top of the page
     * @throws IOException if it cannot be found out what is there already
     */
    public StudyPage(Path folder, String name, String introduction) throws IOException {
        this.folder = folder;
        this.name = name;
        Path files = folder.resolve(name);
        if (Files.isDirectory(files)) {
            try (Stream<Path> there = Files.list(files)) {
                there.forEach(earlier::add);
            }
        }
        if (Files.exists(file())) {
            earlier.add(file());
        }
        text.append(introduction).append('\n');
    }

    /**
     * The top of the page of all studies, from {@code introduction.md}, which is a pattern of {@link String#format}.
     *
     * @param program name and version of the program
     */
    public static String introduction(String program) {
        try (InputStream text = StudyPage.class.getResourceAsStream("introduction.md")) {
            return StudyText.format(
                    new String(text.readAllBytes(), StandardCharsets.UTF_8),
                    program,
                    Machine.text(),
                    Quality.TargetError.DEFAULT.rootMeanSquare(),
                    ObjectTree.SMALLEST_TREE,
                    1 / Ray.FAINTEST);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    /** The file with the figures of a study. */
    public Path dataOf(StudyKind kind) {
        return folder.resolve(name).resolve(kind + ".csv");
    }

    /** The file with the figures of one of several parts of a study, until {@link StudyData} takes them over. */
    public Path dataOf(StudyKind kind, int part, int parts) {
        return folder.resolve(name).resolve(kind + "-part-" + part + "-of-" + parts + ".csv");
    }

    /** The files with the charts of a study. */
    public List<Path> chartsOf(StudyKind kind, Study study) {
        return study.charts().stream().map(chart -> fileOf(kind, chart)).toList();
    }

    private Path fileOf(StudyKind kind, Chart chart) {
        return folder.resolve(name).resolve(kind + "-" + chart.problem() + ".png");
    }

    /** Writes a file and returns where it lies. */
    private Path put(Path file, byte[] content) throws IOException {
        boolean replace = earlier.contains(file);
        Path place = PendingFile.save(file, replace, out -> out.write(content));
        return replace ? file : place;
    }

    /** Adds a study: writes its charts, and puts them and what follows from its figures on the page. */
    public Conclusion add(StudyKind kind, Study study, List<Measurement> all) throws IOException {
        Conclusion conclusion = Conclusion.of(study, all);
        text.append("\n## " + heading(kind.toString()) + "\n\n" + StudyText.of(kind + ".question") + "\n\n"
                + conclusion.answer() + "\n\n");
        for (Chart chart : study.charts()) {
            Path file = put(fileOf(kind, chart), ChartDrawing.png(chart, all));
            String link = name + "/" + file.getFileName();
            text.append("![").append(chart.title()).append("](").append(link).append(")\n");
        }
        text.append("\n| criterion | demanded | found | met |\n|---|---|---|---|\n");
        for (Conclusion.Finding finding : conclusion.findings()) {
            text.append(StudyText.format(
                    "| %s | %s | %s | %s |\n",
                    finding.criterion(),
                    finding.demanded(),
                    finding.found(),
                    finding.holds() ? "yes" : "**no: something is broken**"));
        }
        text.append("\nSettings: ").append(study.settings()).append(".\n");
        text.append(StudyText.format("Figures: [%s.csv](%s/%s.csv)\n", kind, name, kind));
        return conclusion;
    }

    /** Writes the page and says where it is. */
    public Path write() throws IOException {
        return put(file(), text.toString().getBytes(StandardCharsets.UTF_8));
    }

    /** The page itself, whether it is written yet or not. */
    public Path file() {
        return folder.resolve(name + ".md");
    }

    /** The text with a capital at its beginning. */
    static String heading(String text) {
        return Character.toUpperCase(text.charAt(0)) + text.substring(1);
    }
}
