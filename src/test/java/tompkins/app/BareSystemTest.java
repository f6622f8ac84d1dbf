package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The program where something of a desktop is missing: the display, fonts, or a name of the user. */
class BareSystemTest extends ShellTest {

    private static final String ANIMATE =
            "tompkins animate small.json --caption --from 0 --to 0.5 --duration 0.1 -o film.gif";

    @BeforeEach
    void writeScene() throws IOException {
        writeSmallScene();
    }

    /** As after the connection of an ssh with forwarding has ended. */
    @ParameterizedTest
    @ValueSource(strings = {ANIMATE, "tompkins study depth", "tompkins small.json"})
    void aDisplayThatIsSetButDeadIsNotMissed(String line) throws IOException, InterruptedException {
        ProgramRun run = shell("export DISPLAY=:4242; " + line);

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.err()).doesNotContain("Exception", "X11");
    }

    @Test
    void fontsThatAreMissingAreNamedFirst() throws IOException, InterruptedException {
        assumeThat(Path.of("/etc/fonts/fonts.conf")).exists();
        Files.writeString(folder.resolve("none.conf"), "<fontconfig></fontconfig>");
        String without = "export OPTIONS=-Duser.home=. FONTCONFIG_FILE=$PWD/none.conf; ";

        for (String line : List.of(ANIMATE, "tompkins study tree")) {
            ProgramRun run = shell(without + line);

            assertThat(run.code()).isEqualTo(Failures.FAILURE);
            assertThat(run.out()).isEmpty();
            assertThat(run.err().lines()).hasSize(1);
            assertThat(run.err()).contains("packages fontconfig and fonts-dejavu-core");
        }
        assertThat(folder.resolve("tree")).doesNotExist();
        assertThat(folder.resolve("film.gif")).doesNotExist();
        assertThat(shell(without + ANIMATE.replace("--caption", "")).code()).isZero();
    }

    /** Java says that such a user lives at a question mark. */
    @Test
    void aUserWithoutANameGetsNoFolder() throws IOException, InterruptedException {
        ProgramRun run = shell("export OPTIONS=-Duser.home=?; unset HOME; " + ANIMATE);

        assertThat(run.code()).as(run.err()).isZero();
        try (Stream<Path> made = Files.list(folder)) {
            assertThat(made.map(file -> file.getFileName().toString()))
                    .containsExactlyInAnyOrder("small.json", "film.gif", "err");
        }
    }
}
