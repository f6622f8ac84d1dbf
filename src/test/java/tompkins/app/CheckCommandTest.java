package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.app.ProgramRun.FIG1B;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What {@code tompkins check} finds in scene files and saved photographs. */
class CheckCommandTest {

    @TempDir
    private Path folder;

    /** What shows only when the picture is planned has a place in the file, too. */
    @Test
    void aSphereBeyondAllNumbersIsNamedWithItsLine(@TempDir Path folder) throws IOException {
        Path scene = Files.writeString(folder.resolve("big.json"), """
                {
                  "scene": [
                    {"type": "Sphere"},
                    {"type": "Sphere", "description": "huge", "radius": 1e308}
                  ]
                }
                """);
        for (String command : List.of("check", "explain", "render")) {
            ProgramRun run = ProgramRun.of(command, scene);
            assertThat(run.code()).isEqualTo(Failures.MISTAKE);
            assertThat(run.err())
                    .startsWith(scene + ":4:5: scene[1]: must be of a size that can be worked with")
                    .contains("was \"huge\"");
        }
    }

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
    void checkWarnsOfLostDigits() throws IOException {
        Path fast = Files.writeString(folder.resolve("fast.json"), "{ \"velocity\": { \"gamma\": 1e7 } }");

        ProgramRun run = ProgramRun.of("check", fast, FIG1B);

        assertThat(run.code()).isZero();
        assertThat(run.out().lines()).hasSize(2);
        // 8 gamma u = 8 x 1e7 x 1.1e-16
        assertThat(run.err().strip())
                .isEqualTo(fast + ": warning: gamma 10000000 is above 1000000; directions may be wrong by more than"
                        + " 9e-9 radians");
    }

    @Test
    void checkWarnsOfAPictureThatStaysBlack() throws IOException {
        Path black = Files.writeString(
                folder.resolve("black.json"),
                "{ \"camera\": { \"focus\": { \"type\": \"Group\" }, \"shutter\": { \"type\": \"FocusSurfaceShutter\" } } }");

        ProgramRun run = ProgramRun.of("check", black);

        assertThat(run.code()).isZero();
        assertThat(run.err().strip())
                .isEqualTo(black + ": warning: the focus has no surface, so that no ray crosses the shutter");
    }

    /** The slider of a lesson, the scene, and what is measured must fit each other. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0.2 | 0, 0.5, 0.9 | 0 | lesson.json:4:81: lesson.control.measuredAt: must be from 0 to 0.5, where the slider of the lesson ends, was 0.9",
                "0.6 | 0, 0.5, 0.5 | 0 | lesson.json:2:25: velocity.beta: must be from 0 to 0.5, where the slider of the lesson ends, was 0.6",
                "0.2 | 0, 0.5, 0.5 | 0.8 | lesson.json:8:18: lesson.numbers[0].measurement.first: value must be from 0 to 0.5, where the slider of the lesson ends, was 0.8",
                "0.2 | 0, 0.5, 0.5 | 0 | lesson.json: no mistakes",
            })
    void whatALessonNamesLiesOnItsSlider(double shown, String slider, double compared, String said) throws IOException {
        String[] ends = slider.split(", ");
        Path scene = Files.writeString(folder.resolve("lesson.json"), """
                {
                  "velocity": { "beta": SHOWN, "direction": [0, 0, 1] }, "settings": { "width": 4, "height": 4 },
                  "lesson": {
                    "control": { "number": "velocity.beta", "from": FROM, "to": TO, "measuredAt": AT },
                    "numbers": [{
                      "value": 0.57735, "tolerance": 0.001,
                      "measurement": { "type": "RatioOf",
                        "first": { "type": "WithNumber", "number": "velocity.beta", "value": COMPARED,
                          "measurement": { "type": "RayReading" } } }
                    }]
                  }
                }
                """.replace("SHOWN", Double.toString(shown))
                .replace("FROM", ends[0])
                .replace("TO", ends[1])
                .replace("AT", ends[2])
                .replace("COMPARED", Double.toString(compared)));

        ProgramRun run = ProgramRun.of("check", scene);

        assertThat(run.out() + run.err()).contains(said);
        assertThat(run.code()).isEqualTo(said.endsWith("no mistakes") ? 0 : 2);
    }

    @Test
    void everyMistakeOfAFileIsReportedAtItsPlace() throws IOException {
        Path scene = Files.writeString(folder.resolve("wrong.json"), """
                {
                  "velocity": [0, 0, 1.5],
                  "camera": { "aperturRadius": 0.1 },
                }
                """);

        ProgramRun run = ProgramRun.of("check", scene, FIG1B);

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err())
                .contains("wrong.json:2:")
                .contains("wrong.json:3:")
                .contains("apertureRadius");
        assertThat(run.out()).contains("fig1b.json: no mistakes");
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
}
