package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What {@code tompkins study} writes and says, and that figures which are not as they must be make it fail. */
class StudyCommandTest {

    private static ProgramRun measured;

    @TempDir
    private static Path parent;

    private static Path done;

    @TempDir
    private Path folder;

    @BeforeAll
    static void measure() {
        done = parent.resolve("made");
        measured = ProgramRun.of("study", "depth", "-o", done, "--seed", 7);
    }

    private ProgramRun study(Object... more) {
        Object[] words = {"study", "depth", "-o", folder, "--seed", 7};
        return ProgramRun.of(List.of(words), more);
    }

    /** The figures of a study that is done, with a part of them replaced. */
    private Path figures(String pattern, String replacement) throws IOException {
        Path figures = Files.createDirectory(folder.resolve("depth")).resolve("depth.csv");
        String text = Files.readString(done.resolve("depth/depth.csv"));
        return Files.writeString(figures, text.replaceFirst(pattern, replacement));
    }

    @Test
    void writesPageChartsAndFiguresIntoANewFolder() throws IOException {
        assertThat(measured.code()).as(measured.err()).isZero();
        assertThat(measured.out()).contains("largest error of the program").doesNotContain("BROKEN");
        assertThat(Files.readString(done.resolve("depth.md")))
                .startsWith("# Study: depth")
                .contains("](depth/depth-R=0.90.png)")
                .contains("| criterion | demanded | found | met |", "| yes |");
        assertThat(Files.readAllLines(done.resolve("depth/depth.csv")))
                .contains("# study: depth")
                .anyMatch(line -> line.startsWith("# settings: corridors "))
                .anyMatch(line -> line.startsWith("# machine: "));
        assertThat(done.resolve("depth/depth-R=0.90.png")).isNotEmptyFile();
    }

    /** The largest error of the program, 0.03 instead of 0.0008, is taken from the file and found. */
    @Test
    void failsIfAFigureIsNotAsItMustBe() throws IOException {
        figures("(?m)^(R=0\\.90,the program[^,]*,1000\\.0,[^,]*,[^,]*,[^,]*,[^,]*),.*$", "$1,0.03,0.03,0.03,0.03,0");

        ProgramRun run = study();

        assertThat(run.code()).isEqualTo(Failures.FAILURE);
        assertThat(run.out()).contains("BROKEN: Corridor of mirrors, reflectance 0.90: largest error");
        assertThat(Files.readString(folder.resolve("depth.md"))).contains("**no: something is broken**");
    }

    @Test
    void damagedFiguresAreNamed() throws IOException {
        Path figures = figures("(?m)^(R=0\\.90,the program[^,]*,)[^,]*", "$1garbage");

        ProgramRun run = study();

        assertThat(run.code()).isEqualTo(Failures.FAILURE);
        assertThat(run.err())
                .startsWith(figures + ": no figures of a study: R=0.90,the program: 1/1024 of the light,garbage,")
                .doesNotContain("\tat ");
    }

    @Test
    void figuresOfAnotherVersionAreNotReplacedUnasked() throws IOException {
        Path figures = figures("(?m)^# program: .*$", "# program: Tompkins 0.1");
        String before = Files.readString(figures);

        assertRefused(figures
                + ": holds figures of other settings, another machine or another version; --force replaces them");
        assertThat(figures).hasContent(before);
    }

    @Test
    void aFileThatIsNoTextIsNotReplacedUnasked() throws IOException {
        Path figures = figures("", "");
        byte[] other = {(byte) 0xff, 0, '\n'};
        Files.write(figures, other);

        assertRefused(figures + ": holds figures of other settings");

        assertThat(figures).hasBinaryContent(other);
    }

    @Test
    void aPageThatNoStudyHasMadeIsNotReplacedUnasked() throws IOException {
        Path page = Files.writeString(folder.resolve("depth.md"), "my own notes");

        assertRefused(page + ": there is a file of this name already; --force replaces it");

        assertThat(page).hasContent("my own notes");
        assertThat(folder.resolve("depth")).doesNotExist();
    }

    private void assertRefused(String message) {
        ProgramRun run = study();
        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err()).startsWith(message);
    }

    @Test
    void placesThatCannotBeWrittenAreRefusedFirst() throws IOException {
        Path charts = Files.writeString(folder.resolve("depth"), "a file where the folder of the charts goes");
        assertRefused(charts + ": cannot be written: it is a file, not a folder");
        Files.delete(charts);
        Path page = Files.createDirectory(folder.resolve("depth.md"));
        assertRefused(page + ": cannot be written: ");
        assertThat(charts).doesNotExist();
    }

    @Test
    void anUnwritableChartIsNamed() throws IOException {
        figures("", "");
        Path chart = Files.createDirectories(folder.resolve("depth/depth-R=0.90.png"));

        ProgramRun run = study();

        assertThat(run.code()).isEqualTo(Failures.FAILURE);
        assertThat(run.err().strip()).isEqualTo(chart + ": cannot be written: it is a folder; name a file in it");
        assertThat(chart).isEmptyDirectory();
    }
}
