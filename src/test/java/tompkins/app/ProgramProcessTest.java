package tompkins.app;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.image.PhotographFile;

/**
 * The program as a process of its own, with what it can have there alone: little memory, and an output that is lost.
 */
@Tag("slow")
class ProgramProcessTest {

    private static final String PROGRAM = "\"$JAVA\" -Xmx64m -Xshare:auto -XX:-UsePerfData " + Main.class.getName();

    @TempDir
    private Path folder;

    /** Runs the program with a shell, in which {@code tompkins} is its name. */
    private ProgramRun shell(String line) throws IOException, InterruptedException {
        Path err = folder.resolve("err");
        ProcessBuilder builder = new ProcessBuilder("sh", "-c", "tompkins() { " + PROGRAM + " \"$@\"; }; " + line);
        builder.environment()
                .put(
                        "JAVA",
                        Path.of(System.getProperty("java.home"), "bin", "java").toString());
        builder.environment().put("CLASSPATH", System.getProperty("java.class.path"));
        Process process =
                builder.directory(folder.toFile()).redirectError(err.toFile()).start();
        String out = new String(process.getInputStream().readAllBytes(), UTF_8);
        return new ProgramRun(process.waitFor(), out, Files.readString(err));
    }

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

    /** Ctrl-C, while the picture is written. */
    @Test
    void aProgramThatIsStoppedLeavesNothingHalfWritten() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("sky.json"), "{\"settings\": {\"width\": 1000, \"height\": 800}}");

        ProgramRun run = shell(PROGRAM + " render sky.json -o sky.png --format png16 & p=$!; "
                + "while kill -0 $p 2> /dev/null && [ -z \"$(find . -path './.tompkins*' -name sky.png)\" ]; "
                + "do sleep 0.01; done; kill -TERM $p; wait $p; ls -A | grep -c part");

        assertThat(run.out()).isEqualTo("0\n");
    }

    /** Whoever writes goes on until the last moment, and would leave behind what it writes after the tidying. */
    @Test
    void anAnimationThatIsStoppedLeavesNothingBehind() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("sky.json"), "{\"settings\": {\"width\": 64, \"height\": 48}}");

        for (String pause : List.of("0", "0.01", "0.02", "0.05", "0.1")) {
            ProgramRun run = shell(PROGRAM + " animate sky.json --from 0 --to 0.9 --duration 600 -o frames & p=$!; "
                    + "while kill -0 $p 2> /dev/null && [ -z \"$(find . -name frame0001.png)\" ]; do sleep 0.01; done; "
                    + "sleep " + pause + "; kill -TERM $p; wait $p; echo $?; ls -A | grep -v -e sky -e err");

            assertThat(run.out()).isEqualTo("143\n");
        }
    }

    @Test
    void twoProcessesWithOneNameLoseNothing() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("sky.json"), "{\"settings\": {\"width\": 64, \"height\": 48}}");

        // so long that both have begun before one of them ends
        String render = "tompkins render sky.json --seconds 3";
        ProgramRun run = shell(render + " & " + render + " & wait; ls *.png");

        assertThat(run.out().lines().skip(2)).containsExactly("sky-2.png", "sky.png");
        assertThat(PhotographFile.readScene(folder.resolve("sky-2.png"))).isPresent();
    }

    /** As for 60 000 spheres in a photograph of 64 x 48. */
    @Test
    void aPhotographThatTheMemoryCannotHoldIsNamed() throws IOException, InterruptedException {
        String sphere = "{\"type\": \"Sphere\", \"centre\": [0, 0, 50]}";
        Files.writeString(
                folder.resolve("many.json"),
                "{\"settings\": {\"width\": 8, \"height\": 6}, \"scene\": ["
                        + String.join(",", Collections.nCopies(60_000, sphere)) + "]}");
        assertThat(ProgramRun.of("render", folder.resolve("many.json"), "-o", folder.resolve("many.png"))
                        .code())
                .isZero();

        for (String command : List.of("render many.png -o again.png", "check many.png", "explain many.png")) {
            ProgramRun run =
                    shell("tompkins() { \"$JAVA\" -Xmx24m " + Main.class.getName() + " \"$@\"; }; tompkins " + command);

            assertThat(run.err()).matches("many.png: not enough memory: Java may use 2\\d MB; .*-Xmx\n");
            assertThat(run.code()).isEqualTo(Failures.FAILURE);
        }
    }

    @Test
    void whoeverReadsOnlyTheBeginningHearsNoComplaint() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("good.json"), "{}");

        ProgramRun run = shell("{ tompkins check good.json; echo $? > code; } | true; cat code");

        assertThat(run).isEqualTo(new ProgramRun(0, "0\n", ""));
    }

    @Test
    void aSceneThatTheMemoryCannotHoldIsSaidInOneLine() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("rods.json"), """
                { "scene": [{ "type": "CylinderLattice", "points": [1000, 1000, 1000] }] }
                """);

        ProgramRun run = shell("tompkins check rods.json");

        assertThat(run.err())
                .matches("rods.json: not enough memory: Java may use 6\\d MB; start java with a larger -Xmx\n");
        assertThat(run.out()).isEmpty();
        assertThat(run.code()).isEqualTo(Failures.FAILURE);
    }

    /** 46 bytes a pixel: sums of all samples and of half of them, their number, the picture, and two bytes a level. */
    @Test
    void picturesBeyondTheMemoryAreRefusedFirst() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("large.json"), "{\"settings\": {\"width\": 2000, \"height\": 1500}}");
        for (String command : List.of("explain", "render")) {
            ProgramRun run = shell("tompkins " + command + " large.json --error");

            assertThat(run.code()).isEqualTo(Failures.MISTAKE);
            assertThat(run.err()).startsWith("a picture of 2000 x 1500 pixels needs about 131 MB of memory");
            assertThat(run.out()).isEmpty();
        }
        assertThat(shell("tompkins explain large.json --size 20x15 --error").code())
                .isZero();
    }
}
