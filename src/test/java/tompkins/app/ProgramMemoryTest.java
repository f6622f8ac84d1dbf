package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import tompkins.TestRun;
import tompkins.image.LinearImage;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFormat;
import tompkins.image.ToneCurve;

/** The program with less memory than it needs. */
class ProgramMemoryTest extends ShellTest {

    /** As for 60 000 spheres. Its picture is none of them, which would take long. */
    @Test
    void aPhotographThatTheMemoryCannotHoldIsNamed() throws IOException, InterruptedException {
        String sphere = "{\"type\": \"Sphere\", \"centre\": [0, 0, 50]}";
        String scene = "{\"settings\": {\"width\": 1, \"height\": 1, \"samples\": 1}, \"scene\": ["
                + String.join(",", Collections.nCopies(60_000, sphere)) + "]}";
        PhotographFile.write(
                folder.resolve("many.png"),
                new LinearImage(1, 1, new float[3]),
                PictureFormat.PNG,
                ToneCurve.LINEAR,
                new PhotographInfo("many", "tompkins", scene, Optional.empty(), false, ""),
                true);

        List<String> commands = List.of("check many.png", "render many.png -o again.png", "explain many.png");
        for (String command : commands.subList(0, TestRun.cases(1, 3))) {
            ProgramRun run =
                    shell("tompkins() { \"$JAVA\" -Xmx24m " + Main.class.getName() + " \"$@\"; }; tompkins " + command);

            assertThat(run.err()).matches("many.png: not enough memory: Java may use 2\\d MB; .*-Xmx\n");
            assertThat(run.code()).isEqualTo(Failures.FAILURE);
        }
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

    /** 70 bytes a pixel: the film takes 32, the picture 12, two bytes a level 6, and the estimate of its error 20. */
    @Test
    void picturesBeyondTheMemoryAreRefusedFirst() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("large.json"), "{\"settings\": {\"width\": 2000, \"height\": 1500}}");
        for (String command : List.of("explain", "render")) {
            ProgramRun run = shell("tompkins " + command + " large.json --error");

            assertThat(run.code()).isEqualTo(Failures.MISTAKE);
            assertThat(run.err()).startsWith("a picture of 2000 x 1500 pixels needs about 200 MB of memory");
            assertThat(run.out()).isEmpty();
        }
        assertThat(shell("tompkins explain large.json --size 20x15 --error").code())
                .isZero();
    }
}
