package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.app.ProgramRun.FIG1B;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CheckCommandTest {

    @TempDir
    private Path folder;

    /** At 0.6 c the way of 3 takes 5 in the scene and 4 on board. */
    @Test
    void challengesHaveToBeMetByTheirOwnFlights() throws IOException {
        String ride = """
                {"rides": [{"name": "there", "velocity": [0, 0, 0.6],
                  "legs": [{"seconds": 1, "properTime": 4}],
                  "challenge": [{"position": [0, 0, 1], "within": 0.1}, {"position": [0, 0, 3], "within": 0.1, "latest": LATEST}]}]}
                """;
        Path early = Files.writeString(folder.resolve("early.json"), ride.replace("LATEST", "4.1"));
        Path late = Files.writeString(folder.resolve("late.json"), ride.replace("LATEST", "3.5"));

        assertThat(ProgramRun.of("check", early).out()).contains(": no mistakes");
        ProgramRun run = ProgramRun.of("check", late);
        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err())
                .contains(
                        "late.json:2:",
                        "rides[0].legs: must be a flight that meets the challenge of the ride, was one"
                                + " that misses goal 2 of 2");
    }

    @Test
    void checkTellsOfAPictureThatIsCutThoughItsSceneIsSound() throws IOException {
        Path photograph = folder.resolve("photograph.png");
        ProgramRun.of("render", FIG1B, "-o", photograph, "--size", "64x48");
        byte[] bytes = Files.readAllBytes(photograph);
        Path cut = Files.write(folder.resolve("cut.png"), Arrays.copyOf(bytes, bytes.length - 500));

        ProgramRun run = ProgramRun.of("check", cut, photograph);

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.out().strip()).isEqualTo(photograph + ": no mistakes");
        assertThat(run.err().strip())
                .isEqualTo(
                        cut + ": the picture is damaged: the file ends too early or contradicts itself; its scene has"
                                + " no mistakes: render can take the picture again");
        Path again = folder.resolve("again.png");
        ProgramRun.of("render", cut, "-o", again);
        assertThat(Files.readAllBytes(again)).isEqualTo(bytes);
    }

    @Test
    void checkAndRenderAgreeOnPicturesBeyondTheMemory() throws IOException {
        Path large = Files.writeString(
                folder.resolve("large.json"),
                "{ \"settings\": { \"width\": 10000, \"height\": 10000, \"samples\": 2 } }");

        ProgramRun check = ProgramRun.of("check", large);
        ProgramRun render = ProgramRun.of("render", large, "-o", folder.resolve("b.png"));

        assertThat(check.err()).contains("a picture of 10000 x 10000 pixels needs about");
        assertThat(render.err()).contains("a picture of 10000 x 10000 pixels needs about");
        assertThat(check.code()).isEqualTo(2).isEqualTo(render.code());
    }

    @Test
    void allThatMeasuresWarnsOfLargeSpeeds() throws IOException {
        Path scene = Files.writeString(folder.resolve("fast.json"), """
                { "velocity": { "gamma": 1e7 }, "scene": [{ "type": "Sphere", "centre": [0, 0, 5] }] }
                """);
        String lesson = "scenes/lesson-01-round-ball.json";
        for (ProgramRun run : List.of(
                ProgramRun.of("trace", scene, "--pixel", "3,3"),
                ProgramRun.of("measure", "between", scene, "--pixel", "3,3", "--pixel", "4,3"),
                ProgramRun.of(
                        "measure",
                        "lesson",
                        lesson,
                        "--set",
                        "lesson.control.to=0.9999999999999",
                        "--set",
                        "lesson.control.measuredAt=0.9999999999999"))) {
            assertThat(run.err()).startsWith("warning: gamma ").contains(" is above 1000000; directions may be wrong");
        }
    }

    @Test
    void moreVelocitiesThanAreSearchedAreRefused() throws IOException {
        String objects = IntStream.range(0, 257)
                .mapToObj(i -> "{\"type\": \"Moving\", \"velocity\": [0, 0, 0." + (100 + i) + "]}")
                .collect(Collectors.joining(", "));
        Path scene = Files.writeString(folder.resolve("many.json"), "{\"scene\": [" + objects + "]}");
        ProgramRun run = ProgramRun.of("check", scene);
        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err())
                .endsWith(": scene[256]: velocity must be one of at most 256 in a scene, was [0, 0, 0.356]\n");
    }
}
