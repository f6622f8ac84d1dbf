package tompkins.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * What {@code docs/speed-and-accuracy.md} says is what its data say: {@code tompkins study all --force -o docs} takes
 * them again.
 */
class DocumentedStudiesTest {

    private static final Path PAGE = Path.of("docs/speed-and-accuracy.md");
    private static final Path FOLDER = Path.of("docs/speed-and-accuracy");

    private static StudyData data(StudyKind kind) {
        try {
            return StudyData.read(FOLDER.resolve(kind + ".csv")).orElseThrow();
        } catch (IOException missing) {
            throw new UncheckedIOException(missing);
        }
    }

    @Test
    void thePageIsWhatFollowsFromItsData() throws IOException {
        List<StudyData> all =
                Stream.of(StudyKind.values()).map(DocumentedStudiesTest::data).toList();
        StudyPage page = new StudyPage("speed-and-accuracy", StudyPage.introduction(all));
        for (StudyKind kind : StudyKind.values()) {
            StudyData data = data(kind);
            Study study = kind.study(1);
            assertThat(data.origin().study()).isEqualTo(kind.toString());
            // all scenes too: a scene that is new or has another name is not among the settings of old figures
            assertThat(data.origin().settings()).isEqualTo(study.settings());
            assertThat(page.add(kind, study, data).findings()).allMatch(Conclusion.Finding::holds);
            assertThat(study.charts())
                    .allSatisfy(chart ->
                            assertThat(FOLDER.resolve(chart.file(kind))).isRegularFile());
        }
        assertThat(Files.readString(PAGE)).isEqualTo(page.text());
    }

    @Test
    void thePromiseIsTakenOfEveryScene() throws IOException {
        List<String> scenes = data(StudyKind.ANTIALIASING).measurements().stream()
                .map(StudyPoint::problem)
                .filter(problem -> problem.startsWith("promise:"))
                .map(problem -> problem.split(":")[1] + ".json")
                .distinct()
                .toList();
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            assertThat(scenes)
                    .containsExactlyInAnyOrderElementsOf(
                            files.map(file -> file.getFileName().toString())
                                    .filter(name -> name.endsWith(".json"))
                                    .toList());
        }
    }

    @Test
    void onePageHasOneVersion() {
        StudyData tree = data(StudyKind.TREE);
        StudyData.Origin origin = tree.origin();
        StudyData older = new StudyData(
                new StudyData.Origin(origin.study(), origin.settings(), "Tompkins 1.0.0", origin.machine()),
                tree.measurements());
        assertThatThrownBy(() -> StudyPage.introduction(new ArrayList<>(List.of(tree, older))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Tompkins 1.0.0");
    }
}
