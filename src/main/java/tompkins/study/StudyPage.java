package tompkins.study;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import tompkins.image.FileException;
import tompkins.image.PendingFile;
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
     * The top of the page of all studies.
     *
     * @param program name and version of the program
     */
    public static String introduction(String program) {
        return Finding.text(
                """
                # Speed and accuracy

                A picture can be had soon, or it can be right; each choice that the program makes for you was measured against
                the others. All of this page, charts and figures too, is made by one command, which takes about ten minutes:

                    java -jar target/tompkins.jar study all -o docs

                The figures were measured with %s (%s). What the csv files hold already
                is not measured again; figures of another machine are replaced only with `--force`.

                ## What the program does because of these studies

                | choice | default | study |
                |---|---|---|
                | places in pixel and on the lens | Sobol points, Owen-scrambled in each pixel | [aperture](#aperture) |
                | moments while the shutter is open | one more dimension of these points | [exposure](#exposure) |
                | samples per pixel | one in the centre, unless the scene says another number | [antialiasing](#antialiasing) |
                | how good a picture `--error` makes | %s, half a step of an 8-bit picture, with samples where they are needed | [antialiasing](#antialiasing) |
                | form of the Lorentz transformation | half angles in double precision | [precision](#precision) |
                | search for the nearest object | list below %d objects, tree from there on | [tree](#tree) |
                | end of a ray between mirrors | when it can bring less than 1/%.0f of the light | [depth](#depth) |
                | previews in the window | every 8th, 4th, 2nd pixel, interpolated | [preview](#preview) |
                | formulas near rest, near light and far away | those that keep their digits | [stability](#stability) |

                ## How to read the charts

                Both axes are logarithmic, so that "the error falls as a power of the cost" is a straight line. The number in
                brackets is this power, the slope of the curve as it is drawn. The slopes in the tables are those over the
                number of samples, or over gamma where the power law holds, and differ a little. Lower left is better. Rings are what the program
                does. The yellow band is the Pareto front: the points that no other beats in both cost and error. Bars reach from
                the smallest to the largest of several runs. The RMS error is the root of the mean square error over all pixels and
                channels, in linear light where white is 1. A grey line is the error of the reference itself, found from its two
                halves, where the exact answer is not known.

                In the csv files, `error` is the RMS error. In the studies of precision and stability it is the largest error, in
                that of the tree the number of rays that find something else, and in the rows `independence` of the aperture the
                ratio of the table.
                """,
                program,
                Machine.text(),
                Quality.TargetError.DEFAULT.rootMeanSquare(),
                ObjectTree.SMALLEST_TREE,
                1 / Ray.FAINTEST);
    }

    /** The file with the figures of a study. */
    public Path dataOf(StudyKind kind) {
        return folder.resolve(name).resolve(kind + ".csv");
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
        if (earlier.contains(file)) {
            StudyData.replace(file, content);
            return file;
        }
        try (PendingFile pending = PendingFile.newFile(file)) {
            pending.write(content);
            return pending.commit();
        } catch (IOException failure) {
            throw FileException.cannotWrite(file, failure);
        }
    }

    /** Adds a study: writes its charts, and puts them and its findings on the page. */
    public void add(StudyKind kind, Study study, List<Measurement> all) throws IOException {
        text.append(
                "\n## " + heading(kind.toString()) + "\n\n" + study.question() + "\n\n" + study.answer(all) + "\n\n");
        for (Chart chart : study.charts()) {
            Path file = put(fileOf(kind, chart), ChartDrawing.png(chart, all));
            String link = name + "/" + file.getFileName();
            text.append("![").append(chart.title()).append("](").append(link).append(")\n");
        }
        text.append("\n| criterion | demanded | found | met |\n|---|---|---|---|\n");
        for (Finding finding : study.findings(all)) {
            text.append(Finding.text(
                    "| %s | %s | %s | %s |\n",
                    finding.criterion(),
                    finding.demanded(),
                    finding.found(),
                    finding.holds() ? "yes" : "**no: something is broken**"));
        }
        text.append("\nSettings: ").append(study.settings()).append(".\n");
        text.append(Finding.text("Figures: [%s.csv](%s/%s.csv)\n", kind, name, kind));
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
