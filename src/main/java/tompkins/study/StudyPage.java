package tompkins.study;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** A page with the charts of studies and the sentences that they lead to, in Markdown, beside a folder with their files. */
public final class StudyPage {

    private final Path folder;
    private final String name;
    private final StringBuilder text = new StringBuilder();

    /**
     * A page that will be {@code folder/name.md}, with its charts and data in {@code folder/name}.
     *
     * @param introduction Markdown for the top of the page
     */
    public StudyPage(Path folder, String name, String introduction) {
        this.folder = folder;
        this.name = name;
        text.append(introduction).append('\n');
    }

    /** The top of the page of all studies. */
    public static String introduction() {
        return """
                # Speed and accuracy

                Both count, so each choice that the program makes was measured against others. Every chart has logarithmic
                axes; the number in brackets is the slope of the curve (against the number of rays, where the time is drawn), the
                yellow band the Pareto front: the points that no other beats in both. Bars show the smallest and the largest of several runs. This page, its charts and its
                figures are made by `tompkins study all -o docs`.

                What the program does because of them:

                | choice | default | study |
                |---|---|---|
                | places in pixel and lens | Sobol points, Owen-scrambled in each pixel | aperture |
                | number of samples | what the scene says; `--error` and `--seconds` put them where they are needed | antialiasing |
                | first samples of `--error` | 16 through a wide lens, 1 through a pinhole, 16 where neighbours differ | antialiasing |
                | form of the Lorentz transformation | half angles in double precision | precision |
                | search for the nearest object | list below 40 objects, tree from there on | tree |
                | end of a ray between mirrors | when it brings less than 1/1024 of the light | depth |
                | previews | every 8th, 4th, 2nd pixel, interpolated | preview |
                """;
    }

    /** The file with the figures of a study. */
    public Path dataOf(Study study) {
        return folder.resolve(name).resolve(study.name() + ".csv");
    }

    /** Adds a study: writes its charts, and puts them and its findings on the page. */
    public void add(Study study, List<Measurement> all) throws IOException {
        text.append("\n## ").append(heading(study.name())).append("\n\n");
        text.append(study.question()).append("\n\n");
        for (Finding finding : study.findings(all)) {
            text.append("- ")
                    .append(finding.sentence())
                    .append(finding.holds() ? "" : " **This is not so: something is broken.**")
                    .append('\n');
        }
        text.append('\n');
        for (Chart chart : study.charts()) {
            String file = name + "/" + study.name() + "-" + chart.problem() + ".png";
            StudyData.replace(folder.resolve(file), ChartDrawing.png(chart, all));
            text.append("![").append(chart.title()).append("](").append(file).append(")\n");
        }
        text.append("\nFigures: [")
                .append(study.name())
                .append(".csv](")
                .append(name)
                .append('/')
                .append(study.name())
                .append(".csv)\n");
    }

    /** Writes the page and says where it is. */
    public Path write() throws IOException {
        Path file = folder.resolve(name + ".md");
        StudyData.replace(file, text.toString().getBytes(StandardCharsets.UTF_8));
        return file;
    }

    private static String heading(String name) {
        return Character.toUpperCase(name.charAt(0)) + name.substring(1);
    }
}
