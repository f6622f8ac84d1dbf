package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What {@code tompkins study} writes and says, and that figures which are not as they must be make it fail. */
class StudyCommandTest {

    @TempDir
    private static Path done;

    @TempDir
    private Path folder;

    @BeforeAll
    static void measure() {
        assertThat(ProgramRun.of("study", "stability", "-o", done).code()).isZero();
    }

    /** The figures of a study that is done. */
    private Path measured() throws IOException {
        Path figures = Files.createDirectory(folder.resolve("stability")).resolve("stability.csv");
        return Files.copy(done.resolve("stability/stability.csv"), figures);
    }

    @Test
    void writesPageChartsAndFigures() throws IOException {
        ProgramRun run = ProgramRun.of("study", "stability", "-o", folder, "--seed", 7);

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out()).contains("Gamma - 1 of a low speed").doesNotContain("BROKEN");
        Path page = folder.resolve("stability.md");
        assertThat(Files.readString(page)).contains("| criterion | demanded | found | met |", "| yes |");
        assertThat(Files.readAllLines(folder.resolve("stability/stability.csv")))
                .contains("# study: stability")
                .anyMatch(line -> line.startsWith("# settings: seed 7,"))
                .anyMatch(line -> line.startsWith("# machine: "));
        assertThat(folder.resolve("stability/stability-rest.png")).isNotEmptyFile();
    }

    @Test
    void failsIfAFigureIsNotAsItMustBe() throws IOException {
        Path figures = measured();
        // the program's own error close to rest, 3 % instead of its last digits
        String broken = Files.readString(figures)
                .replaceAll("(?m)^(rest,the program,1\\.0E-5,[^,]*,[^,]*,[^,]*,[^,]*),.*$", "$1,0.03,0.03,0.03,0.03,0");
        Files.writeString(figures, broken);

        ProgramRun run = ProgramRun.of("study", "stability", "-o", folder);

        assertThat(run.code()).isEqualTo(Failures.FAILURE);
        assertThat(run.out()).contains("BROKEN: Gamma - 1 of a low speed");
        assertThat(Files.readString(folder.resolve("stability.md"))).contains("**no: something is broken**");
    }

    /** What a study says, without its last end of line, that ends with a code when it should write to a folder. */
    private static String refusal(Path to, int code) {
        ProgramRun run = ProgramRun.of("study", "stability", "-o", to);
        assertThat(run.code()).isEqualTo(code);
        return run.err().strip();
    }

    @Test
    void folderThatCannotBeMadeIsNamedWithTheReason() throws IOException {
        Path file = Files.writeString(folder.resolve("stability"), "a file where the folder of the charts goes");

        assertThat(refusal(folder, Failures.FAILURE))
                .isEqualTo(file + ": cannot be written: it is a file, not a folder");
    }

    @Test
    void anUnwritableChartIsNamedAndLeavesNothing() throws IOException {
        Path chart = Files.createDirectories(folder.resolve("stability/stability-rest.png"));

        assertThat(refusal(folder, Failures.FAILURE))
                .isEqualTo(chart + ": cannot be written: it is a folder; name a file in it");
        assertThat(chart).isEmptyDirectory();
        assertThat(folder.resolve("stability")).isDirectoryNotContaining("glob:**.part");
    }

    @Test
    void anUnwritablePageIsRefusedFirst() throws IOException {
        Path page = Files.createDirectory(folder.resolve("stability.md"));

        assertThat(refusal(folder, Failures.MISTAKE)).startsWith(page + ": cannot be written: ");
        assertThat(folder.resolve("stability")).doesNotExist();
    }

    @Test
    void aFolderThatCannotBeMadeIsAMistake() throws IOException {
        Path file = Files.writeString(folder.resolve("mine.txt"), "mine");
        Path none = folder.resolve("none");
        assertThat(refusal(file, Failures.MISTAKE)).isEqualTo(file + ": cannot be written: it is a file, not a folder");
        assertThat(refusal(file.resolve("x"), Failures.MISTAKE)).endsWith("there is no folder " + file);
        assertThat(refusal(none.resolve("x"), Failures.MISTAKE)).endsWith("there is no folder " + none);
        assertThat(folder).isDirectoryContaining(file::equals).isDirectoryNotContaining(path -> !path.equals(file));
        assertThat(Files.readString(file)).isEqualTo("mine");
    }

    @Test
    void aNewFolderIsMadeWhereItsParentIs() {
        Path made = folder.resolve("made");
        assertThat(ProgramRun.of("study", "stability", "-o", made).code()).isZero();
        assertThat(made.resolve("stability.md")).exists();
        assertThat(made.resolve("stability/stability.csv")).exists();
    }

    @Test
    void damagedFiguresAreNamed() throws IOException {
        Path figures = measured();
        Files.writeString(
                figures, Files.readString(figures).replaceFirst("(?m)^(rest,the program,)[^,]*", "$1garbage"));

        assertThat(refusal(folder, Failures.FAILURE))
                .startsWith(figures + ": no figures of a study: rest,the program,garbage,")
                .doesNotContain("\tat ");
    }

    @Test
    void figuresOfOtherSettingsAreNotReplacedUnasked() throws IOException {
        Path figures = measured();
        String before = Files.readString(figures);

        ProgramRun other = ProgramRun.of("study", "stability", "-o", folder, "--seed", 2);

        assertThat(other.code()).isEqualTo(Failures.MISTAKE);
        assertThat(other.err().strip())
                .isEqualTo(
                        figures
                                + ": holds figures of other settings, another machine or another version; --force replaces them");
        assertThat(figures).hasContent(before);
        assertThat(ProgramRun.of("study", "stability", "-o", folder, "--seed", 2, "--force")
                        .code())
                .isZero();
        assertThat(Files.readString(figures)).contains("# settings: seed 2,");
    }

    @Test
    void aFileThatIsNoTextIsNotReplacedUnasked() throws IOException {
        Path figures = Files.createDirectory(folder.resolve("stability")).resolve("stability.csv");
        byte[] other = {(byte) 0xff, 0, '\n'};
        Files.write(figures, other);

        assertThat(refusal(folder, Failures.MISTAKE)).startsWith(figures + ": holds figures of other settings");
        assertThat(figures).hasBinaryContent(other);
    }

    @Test
    void aPageThatNoStudyHasMadeIsNotReplacedUnasked() throws IOException {
        Path page = Files.writeString(folder.resolve("stability.md"), "my own notes");

        assertThat(refusal(folder, Failures.MISTAKE))
                .isEqualTo(page + ": there is a file of this name already; --force replaces it");
        assertThat(page).hasContent("my own notes");
        assertThat(folder.resolve("stability")).doesNotExist();
    }

    /** The last number of a line, 0.0123, may be cut to one that is as good a number, 0.01. */
    @Test
    void aLineThatWasCutInItsLastNumberIsMeasuredAgain() throws IOException {
        Path figures = measured();
        String before = Files.readString(figures).strip();
        String last = before.substring(before.lastIndexOf('\n') + 1);
        Files.writeString(figures, before + "99");

        assertThat(ProgramRun.of("study", "stability", "-o", folder).code()).isZero();

        assertThat(Files.readAllLines(figures)).noneMatch((last + "99")::equals);
    }

    /** One ray goes through every 8th pixel of every 8th row for the first preview. */
    @Test
    void figuresOfAnotherSceneOfTheSameNameDoNotCount() throws IOException {
        Path large = scene("large", 64, 48);
        Path small = scene("small", 32, 24);

        String figures = previewOf(large);
        assertThat(figures).contains(",8.0,48.0,").containsPattern("scenes \\[scene [0-9a-f]{8}]");
        assertThat(previewOf(large)).as("figures of the same scene count").isEqualTo(figures);
        assertThat(previewOf(small)).contains(",8.0,12.0,").doesNotContain(",8.0,48.0,");
    }

    private Path scene(String in, int width, int height) throws IOException {
        Path parent = Files.createDirectory(folder.resolve(in));
        return Files.writeString(
                parent.resolve("mine.json"),
                "{\"settings\": {\"width\": " + width + ", \"height\": " + height
                        + "}, \"scene\": [{\"type\": \"Sphere\", \"centre\": [0, 0, 3]}]}");
    }

    private String previewOf(Path scene) throws IOException {
        ProgramRun.of("study", "preview", scene, "-o", folder, "--force");
        return Files.readString(folder.resolve("preview/preview.csv"));
    }

    @Test
    void unknownStudyIsAMistake() {
        ProgramRun run = ProgramRun.of("study", "speed", "-o", folder);

        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err().strip())
                .isEqualTo(
                        "NAME must be one of aperture, exposure, antialiasing, precision, tree, depth, preview, stability, all;"
                                + " was speed");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void sceneOfAStudyThatMakesItsOwnIsAMistake() {
        ProgramRun run = ProgramRun.of("study", "tree", "scenes/smallest.json", "-o", folder);

        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err()).contains("tree", "smallest.json");
        assertThat(folder).isEmptyDirectory();
    }
}
