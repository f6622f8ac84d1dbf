package tompkins.study;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import tompkins.ray.Ray;
import tompkins.render.Quality;
import tompkins.search.ObjectTree;

/**
 * A page in Markdown: what follows from the figures of studies, and whether they meet their demands, with links to
 * charts and figures in a folder beside it. All figures in its sentences come from the data.
 */
public final class StudyPage {

    private final String folder;
    private final StringBuilder text = new StringBuilder();

    /**
     * A page.
     *
     * @param folder the name of the folder with charts and figures
     * @param introduction Markdown for the top of the page
     */
    public StudyPage(String folder, String introduction) {
        this.folder = folder;
        text.append(introduction).append('\n');
    }

    /**
     * The top of the page of all studies, from {@code introduction.md}, which is a pattern of {@link String#format}.
     *
     * @param all the figures of all studies
     * @throws IllegalArgumentException if they come from several programs or machines
     */
    public static String introduction(List<StudyData> all) {
        List<String> signatures = all.stream()
                .map(data -> data.origin().program() + " (" + data.origin().machine() + ")")
                .distinct()
                .toList();
        if (signatures.size() != 1) {
            throw new IllegalArgumentException("one page cannot show figures of " + String.join(" and ", signatures));
        }
        try (InputStream text = StudyPage.class.getResourceAsStream("introduction.md")) {
            return StudyText.format(
                    new String(text.readAllBytes(), StandardCharsets.UTF_8),
                    signatures.get(0),
                    Quality.TargetError.DEFAULT.rootMeanSquare(),
                    ObjectTree.SMALLEST_TREE,
                    ObjectTree.CHORDS_PER_RADIAN,
                    1 / Ray.FAINTEST);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    /** Adds a chapter with the charts of a study and what follows from its figures. */
    public Conclusion add(StudyKind kind, Study study, StudyData data) {
        Conclusion conclusion = Conclusion.of(study, data.measurements());
        text.append("\n## " + heading(kind.toString()) + "\n\n" + StudyText.of(kind + ".question") + "\n\n"
                + conclusion.answer() + "\n\n");
        for (Chart chart : study.charts()) {
            text.append(StudyText.format("![%s](%s/%s)\n", chart.title(), folder, chart.file(kind)));
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
        text.append("\nSettings: ").append(data.origin().settings()).append(".\n");
        text.append(StudyText.format("Figures: [%s.csv](%s/%s.csv)\n", kind, folder, kind));
        return conclusion;
    }

    /** The whole page. */
    public String text() {
        return text.toString();
    }

    /** The text with a capital at its beginning. */
    static String heading(String text) {
        return Character.toUpperCase(text.charAt(0)) + text.substring(1);
    }
}
