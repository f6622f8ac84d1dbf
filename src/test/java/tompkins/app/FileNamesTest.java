package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Names of files that cannot be taken as they are, and the command that explains the others. */
class FileNamesTest {

    private static final String FIG1B = "scenes/fig1b.json";

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

    /** The program looks for files in the folder where it was started, so that the file has to lie there. */
    @ParameterizedTest
    @CsvSource({"render -strange.json", "check -strange.json", "render scenes/fig1b.json -strange.json"})
    void aFileThatLooksLikeAnOptionIsNamedWithTheWayToGiveIt(String line) throws IOException {
        Path strange = Files.writeString(Path.of("-strange.json"), "{}");
        try {
            ProgramRun run = ProgramRun.of((Object[]) line.split(" "));

            assertThat(run.code()).isEqualTo(Failures.MISTAKE);
            assertThat(run.err().lines().findFirst().orElseThrow())
                    .endsWith(": -strange.json: what begins with - is read as an option; the file of this name is "
                            + Path.of(".").resolve(strange));
            assertThat(ProgramRun.of("check", "./-strange.json").code()).isZero();
        } finally {
            Files.delete(strange);
        }
    }

    @Test
    void helpIsACommandToo() {
        assertThat(ProgramRun.of("help").out())
                .isEqualTo(ProgramRun.of("--help").out());
        assertThat(ProgramRun.of("help", "render").out())
                .isEqualTo(ProgramRun.of("render", "--help").out())
                .contains("--samples");
        assertThat(ProgramRun.of("help", "render").code()).isZero();
        assertThat(ProgramRun.of("help", "rendr").code()).isEqualTo(Failures.MISTAKE);
        assertThat(ProgramRun.of("help", "rendr").err()).contains("rendr");
    }

    @Test
    void missingSceneIsStillMissing() {
        assertThat(ProgramRun.of("render", "--samples", 2).err()).contains("SCENE");
        assertThat(ProgramRun.of("check", FIG1B).code()).isZero();
    }
}
