package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.app.ProgramRun.FIG1B;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.OnLinux;

@OnLinux
class FileNamesTest {

    @ParameterizedTest
    @ValueSource(strings = {"", "render", "check", "explain", "render scenes/fig1b.json -o", "study tree -o"})
    void aNameWithoutALetterIsRefused(String line) {
        Object[] words = (line + " ~").strip().replace(" ", ",").split(",");
        words[words.length - 1] = "";

        ProgramRun run = ProgramRun.of(words);

        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.out()).isEmpty();
        assertThat(run.err().lines().findFirst().orElseThrow()).endsWith(": \"\": no file can have this name");
    }

    @ParameterizedTest
    @ValueSource(strings = {"%s", "%s more words", "check %s", "render scenes/fig1b.json -o %s", "study tree -o %s"})
    void impossibleNamesAreShownWithoutControls(String line) {
        Object[] words = line.replace("%s", "a\0b\u001b\u009bc").split(" ");

        ProgramRun run = ProgramRun.of(words);

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.out()).isEmpty();
        assertThat(run.err().lines().findFirst().orElseThrow()).endsWith(": a b c: no file can have this name");
    }

    /** Files from elsewhere may have names that a terminal would obey; one that is missing is told in one line. */
    @ParameterizedTest
    @CsvFileSource(resources = "file-names.csv", delimiter = '|')
    void namesOfFilesReachNoTerminalAsCodes(String line, @TempDir Path folder) throws IOException {
        String name = folder.resolve("a\u001b[31m\u009b\u0007\rb\u007f\u202ec").toString();
        Files.writeString(Path.of(name + ".json"), "{\"title\": \"a\", \"lights\": []}");
        Files.writeString(Path.of(name + ".hdr"), "#?RADIANCE\n");
        Path bad = Files.writeString(
                folder.resolve("bad.json"),
                "{\"scene\": [{\"type\": \"Silhouette\", \"picture\": \"" + "a\\u001b[31m.hdr\"}]}");
        Files.writeString(folder.resolve("a\u001b[31m.hdr"), "#?RADIANCE\n\u001b\n");

        ProgramRun run = ProgramRun.of((Object[])
                line.replace("%s", name).replace("bad.json", bad.toString()).split(" "));

        assertThat((run.out() + run.err()).replace("\n", "")).isNotEmpty().doesNotContainPattern("[\\p{Cc}\u202e]");
    }

    @Test
    void aMessageAboutANameWithLinesIsOneLine(@TempDir Path folder) {
        ProgramRun run = ProgramRun.of("check", folder.resolve("a\nb: no mistakes\nc.json"));
        assertThat(run.err().strip()).isEqualTo(folder.resolve("a b: no mistakes c.json") + ": there is no such file");
        run = ProgramRun.of("render", FIG1B, "-o", folder.resolve("a\nb.no"));
        assertThat(run.err().strip().lines()).hasSize(1);
        run = ProgramRun.of("render", FIG1B, "-o", folder.resolve("a\nb/c.png"));
        assertThat(run.err().strip().lines()).hasSize(1);
        run = ProgramRun.of("render", FIG1B, "--size=4x3", "-o", folder.resolve("a\nb.png"));
        assertThat(run.out()).startsWith(folder.resolve("a b.png") + "  (");
        assertThat(run.out().lines()).hasSize(1);
    }

    /** A link that leads to itself cannot be read by anybody. */
    @Test
    void aFileThatCannotBeReadIsNoUnknownCommand(@TempDir Path folder) throws IOException {
        Path circle = Files.createSymbolicLink(folder.resolve("circle"), folder.resolve("circle"));
        ProgramRun run = ProgramRun.of(circle.resolve("scene.json"));
        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err()).contains(circle.resolve("scene.json") + ": cannot be read: ");
        assertThat(ProgramRun.of(circle.resolve("scene.json"), "more").err()).contains("too many arguments: more");
    }
}
