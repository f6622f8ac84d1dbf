package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The program among names of files whose letters the locale does not have. */
class ForeignLettersTest extends ShellTest {

    @BeforeEach
    void writeScene() throws IOException {
        writeSmallScene();
    }

    @ParameterizedTest
    @ValueSource(strings = {"render ../small.json", "check ../small.json", "study precision -o new/", "../small.json"})
    void aFolderWithoutLettersInTheLocaleIsNamed(String line) throws IOException, InterruptedException {
        ProgramRun run =
                shell("mkdir 'jos\u00e9' && cd 'jos\u00e9' && export LC_ALL=C; unset DISPLAY; tompkins " + line);

        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err())
                .contains("/jos", ": the locale has no such letters for the names of files", "LC_ALL=C.UTF-8")
                .doesNotContain("Exception");
        try (Stream<Path> all = Files.walk(folder)) {
            assertThat(all.filter(Files::isDirectory)).hasSize(2);
        }
    }

    @Test
    void suchAFolderDoesNotMatterToWholeNames() throws IOException, InterruptedException {
        ProgramRun run = shell(
                "mkdir 'jos\u00e9' && cd 'jos\u00e9' && export LC_ALL=C; tompkins check \"$(dirname \"$PWD\")/small.json\"");

        assertThat(run.code()).as(run.err()).isZero();
    }

    /** What Latin-1 calls é is no letter in UTF-8. */
    @Test
    void aNameOfForeignBytesBecomesNoOther() throws IOException, InterruptedException {
        String foreign = "\"$(printf 'jos\\351')\"";
        for (String line : List.of("render small.json -o " + foreign + ".png", "check " + foreign + ".json")) {
            ProgramRun run = shell("export LC_ALL=C.UTF-8; cp small.json " + foreign + ".json; tompkins " + line);

            assertThat(run.code()).isEqualTo(Failures.MISTAKE);
            assertThat(run.err()).contains("the bytes of this name are no letters in UTF-8");
        }
        try (Stream<Path> all = Files.list(folder)) {
            assertThat(all.filter(file -> file.toString().endsWith(".png"))).isEmpty();
        }
    }
}
