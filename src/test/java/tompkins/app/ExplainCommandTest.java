package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.Thorough;

class ExplainCommandTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "scenes/fig1b.json | --samples 1 | One sample per pixel, in its centre.",
                "scenes/fig1b.json | --samples 5 | 5 samples per pixel, spread evenly over the pixel.",
                "scenes/fig3a.json | --samples 5 | 5 samples per pixel, spread evenly over pixel and lens.",
                "scenes/fig1b.json | --error 0.25 | until the estimated error is 0.25.",
                "scenes/fig3a.json | --seconds 0.1 | spread evenly over pixel and lens, until 0.1 s are over."
            })
    void explainTellsOfTheSamplesThatAreTaken(String scene, String wish, String said) {
        String[] words = wish.split(" ");

        String out = ProgramRun.of("explain", scene, words[0], words[1], "--size", "64x48")
                .out();

        assertThat(out).contains(said);
        assertThat(out.lines().filter(line -> line.toLowerCase(Locale.ROOT).contains("sample")))
                .as("the sentence, and the cost")
                .hasSize(2);
    }

    /** What a terminal obeys, such as the beginning of a colour, comes out of no scene. */
    @Test
    void wordsOfAScenePassNoCodesToATerminal() throws IOException {
        Path scene = Files.writeString(folder.resolve("red.json"), """
                {
                  "title": "a\\u001b[31mtitle",
                  "remarks": "first\\nsecond\\u009b31m",
                  "settings": { "width": 1, "height": 1 },
                  "scene": [{ "type": "Sphere", "description": "a\\u001b[31msphere" }]
                }
                """);

        assertThat(ProgramRun.of("explain", scene).out().lines())
                .startsWith("a [31mtitle", "first", "second 31m")
                .noneMatch(line -> line.chars().anyMatch(Character::isISOControl));
        assertThat(ProgramRun.of("trace", scene, "--pixel", "0,0").out()).contains("Hits a [31msphere\n");
    }

    /**
     * Nothing can be seen of a scene from which the camera flies away at D = 0.07; whoever gets the black picture is
     * told so.
     */
    @Test
    void aPictureThatStaysDarkIsToldByAllThatTakeIt() throws IOException {
        Path scene = Files.writeString(folder.resolve("dark.json"), "{ \"velocity\": [0, 0, -0.99] }");
        Path picture = folder.resolve("dark.png");
        String warning =
                "warning: the light of the scene is too faint to be seen in the middle of the picture, which stays dark";

        ProgramRun render = ProgramRun.of("render", scene, "-o", picture, "--size", "8x6", "--colours", "doppler");

        assertThat(render.code()).isZero();
        assertThat(render.err()).contains(warning);
        assertThat(ProgramRun.of("check", picture).err()).contains("dark.png: " + warning);
        assertThat(ProgramRun.of("render", scene, "-o", folder.resolve("light.png"), "--size", "8x6")
                        .err())
                .doesNotContain("warning");
    }

    @Test
    void explainSaysExactlyHowManySamplesAPictureHas() {
        String one = ProgramRun.of("explain", "scenes/smallest.json", "--size", "100x70")
                .out();
        assertThat(one).contains("with 7000 samples, 1 per pixel.");
        String many = ProgramRun.of("explain", "scenes/smallest.json", "--size", "200x300", "--samples", 64)
                .out();
        assertThat(many).contains("with 3.84 million samples, 64 per pixel.");
    }

    /** The time is written without a power of ten, however long it is. */
    @Test
    @Thorough
    void explainSaysHowLongAWantedErrorTakes() {
        String out = ProgramRun.of("explain", "scenes/smallest.json", "--size", "100x70", "--error", "0.00001")
                .out();
        assertThat(out)
                .containsPattern(
                        "it will take ([0-9.]+ to )?[0-9.]+ s with [0-9.]+( million)? samples, about [0-9.]+ per pixel");
    }

    /** Light that is split at each of 90 spheres: no block of pixels ends soon. */
    @Thorough
    @ParameterizedTest
    @CsvSource({"scene, [0-9.]+ to [0-9.]+ s with", "cameraFrame, too long to predict: .* not one sample was complete"})
    void explainTellsOfAPictureThatIsTooSlowToForetell(String list, String cost) throws IOException {
        String spheres = IntStream.range(0, 90)
                .mapToObj(i -> String.format(
                        Locale.ROOT,
                        "{\"type\": \"Sphere\", \"centre\": [0.05, 0.02, 0.1], \"radius\": %.2f,"
                                + " \"surface\": {\"type\": \"Refractive\", \"indexRatio\": %s}}",
                        0.5 + 0.04 * i,
                        i % 2 == 0 ? "0.45" : "2.4"))
                .collect(Collectors.joining(", "));
        Path scene = Files.writeString(folder.resolve("glass.json"), "{\"" + list + "\": [" + spheres + "]}");

        ProgramRun run = ProgramRun.of("explain", scene, "--error=0.002");

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out()).containsPattern("On this machine it will take " + cost);
    }
}
