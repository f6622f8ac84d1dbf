package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.TestRun;
import tompkins.image.PhotographFile;

/** The program as a process of its own, with what it can have there alone, such as an output that is lost. */
class ProgramProcessTest extends ShellTest {

    @Test
    void outputThatIsLostIsAFailure() throws IOException, InterruptedException {
        assumeThat(Path.of("/dev/full")).exists();
        Files.writeString(folder.resolve("good.json"), "{}");
        for (String line : List.of("check good.json", "trace good.json --pixel 3,2 --json", "--help")) {
            ProgramRun run = shell("tompkins " + line + " > /dev/full");
            assertThat(run.code()).as(line).isEqualTo(Failures.FAILURE);
            assertThat(run.err()).isEqualTo("the output cannot be written: No space left on device\n");
        }
        ProgramRun mistake = shell("tompkins check good.json nothing.json > /dev/full");
        assertThat(mistake.code()).isEqualTo(Failures.MISTAKE);
        assertThat(mistake.err()).contains("nothing.json: there is no such file", "the output cannot be written");
    }

    @Test
    void withoutDisplayAPhotographIsTaken() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("small.json"), "{\"settings\": {\"width\": 32, \"height\": 24}}");

        ProgramRun run = shell("unset DISPLAY; tompkins small.json && tompkins");

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.err()).contains("There is no display: taking the photograph instead of opening the window.");
        assertThat(run.out().lines()).hasSize(2);
        assertThat(ImageIO.read(folder.resolve("small.png").toFile()).getWidth())
                .isEqualTo(32);
        assertThat(PhotographFile.readScene(folder.resolve("town-square.png"))).isPresent();
    }

    /** On a terminal; the picture takes long enough for several of its tiles to be reported. */
    @Test
    void aTerminalShowsWhatIsDoneAndWhatIsLeft() throws IOException, InterruptedException {
        assumeThat(Path.of("/usr/bin/script")).exists();
        Files.writeString(folder.resolve("mirrors.json"), """
                {"settings": {"maximumDepth": 1000}, "scene": [
                    {"type": "Sphere", "centre": [0, 0, 0], "radius": 9, "surface": {"type": "Mirror", "reflectance": 1}}]}
                """);
        Files.writeString(folder.resolve("render"), PROGRAM + " render mirrors.json\n");

        ProgramRun run = shell("timeout 600 script -qfec 'sh render' terminal > /dev/null 2>&1 < /dev/null & p=$!; "
                + "while kill -0 $p 2> /dev/null && ! grep -q ' s left' terminal; do sleep 0.05; done; "
                + "kill $p; wait $p; cat terminal; ls *.png");

        assertThat(run.out().replaceAll("[\\r ]+", " "))
                .containsSubsequence(
                        "reading the scene", "preparing the objects of the scene", "tracing rays", " % ", " s left");
    }

    /** Ctrl-C, while the picture is written. */
    @Test
    void aProgramThatIsStoppedLeavesNothingHalfWritten() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("sky.json"), "{\"settings\": {\"width\": 2000, \"height\": 1600}}");

        ProgramRun run = shell(PROGRAM + " render sky.json -o sky.png --format png16 & p=$!; "
                + "while kill -0 $p 2> /dev/null && [ -z \"$(find . -name '.tompkins*' -size +0)\" ]; "
                + "do sleep 0.01; done; kill -TERM $p; wait $p; ls -A | grep -c part");

        assertThat(run.out()).isEqualTo("0\n");
    }

    /** Whoever writes goes on until the last moment, and would leave behind what it writes after the tidying. */
    @ParameterizedTest
    @CsvSource({"film.gif, '.tompkins*'", "frames, frame0001.png"})
    void aFilmThatIsStoppedLeavesWholeFramesAlone(String output, String begun)
            throws IOException, InterruptedException {
        Files.writeString(folder.resolve("sky.json"), "{\"settings\": {\"width\": 64, \"height\": 48}}");

        for (String pause : List.of("0", "0.05", "0.01", "0.02", "0.1").subList(0, TestRun.cases(1, 5))) {
            ProgramRun run = shell(
                    PROGRAM + " animate sky.json --from 0 --to 0.9 --duration 600 -o " + output
                            + " & p=$!; "
                            + "while kill -0 $p 2> /dev/null && [ -z \"$(find . -name '" + begun
                            + "')\" ]; do sleep 0.01; done; "
                            + "sleep " + pause
                            + "; kill -TERM $p; wait $p; echo $?; ls -A | grep -v -e sky -e err; find frames -not -name 'frame*' 2> /dev/null; rm -rf frames");

            assertThat(run.out()).isEqualTo("143\n" + (output.equals("frames") ? "frames\n" : ""));
        }
    }

    @Test
    void whoeverReadsOnlyTheBeginningHearsNoComplaint() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("good.json"), "{}");

        ProgramRun run = shell("{ tompkins check good.json; echo $? > code; } | true; cat code");

        assertThat(run).isEqualTo(new ProgramRun(0, "0\n", ""));
    }

    /** All of them would take far longer than the program is given. */
    @Test
    void raysThatNobodyReadsAreNotTraced() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("sky.json"), "{\"settings\": {\"width\": 10000, \"height\": 10000}}");

        for (String form : List.of(" --csv", "", " --json").subList(0, TestRun.cases(1, 3))) {
            ProgramRun run = shell("{ timeout 300 " + PROGRAM + " trace sky.json --pixel all" + form
                    + "; echo $? > code; } | head -1 > /dev/null; cat code");

            assertThat(run).as(form).isEqualTo(new ProgramRun(0, "0\n", ""));
        }
    }
}
