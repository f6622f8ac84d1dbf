package tompkins.app;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.app.ProgramRun.FIG1B;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.Thorough;

/** What {@code tompkins explain} says of a picture, what it warns of, and what it foretells. */
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

    @ParameterizedTest
    @ValueSource(strings = {"--error=2", "--error=NaN", "--seconds=0", "--samples=0", "--beta=0,0,1"})
    void explainSaysNothingBesideAMistake(String wish) {
        ProgramRun run = ProgramRun.of("explain", FIG1B, wish);

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.out()).isEmpty();
        assertThat(run.err()).startsWith(wish.substring(0, wish.indexOf('='))).contains(" must be ");
        assertThat(run.err().lines()).hasSize(1);
    }

    @Test
    void numbersThatVanishAreRefusedAsTheyWereTyped() {
        assertThat(ProgramRun.of("explain", FIG1B, "--error=1e-400").err())
                .contains("must be 0 or a number that is not smaller than 4.9e-324, was 1e-400");
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

    @Test
    void explainSaysWhatThereIsToSee() {
        assertThat(ProgramRun.of("explain", FIG1B, "--size", "8x6")
                        .out()
                        .lines()
                        .skip(1))
                .first(as(InstanceOfAssertFactories.STRING))
                .startsWith("The same time and the same position as in Fig. 1(a)");
    }

    /** What needs no focus says nothing of a missing one. */
    @ParameterizedTest
    @CsvSource(
            nullValues = "nothing",
            delimiter = '|',
            value = {
                "'apertureRadius': 0, 'shutter': {'type': 'AperturePlaneShutter'}   | nothing",
                "'apertureRadius': 0.1, 'shutter': {'type': 'AperturePlaneShutter'} | everything is focused at infinity.",
                "'apertureRadius': 0, 'shutter': {'type': 'FocusSurfaceShutter'}    | no ray crosses the shutter.",
                "'apertureRadius': 0.1, 'shutter': {'type': 'FixedPointSurfaceShutter'} | no ray crosses the shutter."
            },
            quoteCharacter = '~')
    void explainWarnsOfAFocusWithoutSurface(String camera, String warning) throws IOException {
        for (String focus : new String[] {"{'type': 'Group'}", "{'type': 'Hidden'}", "{'type': 'Sphere'}"}) {
            String text = "{'camera': {'focus': " + focus + ", " + camera + "}}";
            Path scene = Files.writeString(folder.resolve("focus.json"), text.replace('\'', '"'));

            String out = ProgramRun.of("explain", scene, "--size", "8x6").out();

            boolean warns = warning != null && !focus.contains("Sphere");
            assertThat(out.contains("- Warning: the focus has no surface")).isEqualTo(warns);
            assertThat(out).contains(warns ? "so that " + warning : "except where a ray never crosses the shutter");
        }
    }

    /** What a scene needs for a sentence about what is left out, and the same scene without that. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', textBlock = """
            not the right positions: through a wide aperture | 'cameraFrame': [WINDOW], 'camera': {'apertureRadius': 0.1} \
            | 'cameraFrame': [WINDOW]
            not the right positions: with a shutter that opens at different times | 'velocity': [0, 0, 0.5], 'cameraFrame': [WINDOW], \
            'camera': {'shutter': {'type': 'DetectorPlaneShutter'}} | 'velocity': [0, 0, 0.5], 'cameraFrame': [WINDOW]
            not the right positions | 'scene': [{'type': 'Plane', 'surface': {'type': 'Tiling', 'second': {'type': 'GalileoWindow'}}}], \
            'camera': {'apertureRadius': 0.1} | 'scene': [{'type': 'Plane'}], 'camera': {'apertureRadius': 0.1}
            leave its frequency as it is | 'velocity': [0, 0, 0.5], 'colours': 'doppler', 'cameraFrame': [WINDOW] \
            | 'velocity': [0, 0, 0.5], 'colours': 'doppler'
            do nothing else to it: IdealLens. A wave would be delayed | 'scene': [{'type': 'Disc', 'surface': {'type': 'IdealLens'}}] \
            | 'scene': [{'type': 'Disc'}]
            do nothing else to it: ConfocalLensletArray. | 'cameraFrame': [{'type': 'Disc', 'surface': {'type': 'Tiling', \
            'second': {'type': 'ConfocalLensletArray'}}}] | 'cameraFrame': [WINDOW]
            and a part of it mirrored | 'scene': [{'type': 'Disc', 'surface': {'type': 'ComplexRefraction'}}] \
            | 'scene': [{'type': 'Disc', 'surface': {'type': 'Refractive'}}]
            The focus ignores windows, glass and mirrors | 'cameraFrame': [WINDOW], 'camera': {'apertureRadius': 0.1} \
            | 'cameraFrame': [WINDOW]
            Image points ignore the objects that move with the camera | 'cameraFrame': [WINDOW], \
            'scene': [{'type': 'Group', 'objects': [{'type': 'ImagePointGrid'}]}] | 'cameraFrame': [WINDOW], 'scene': [{'type': 'Sphere'}]
            Lamps do not get fainter with distance. | 'scene': [{'type': 'Sphere'}] \
            | 'scene': [{'type': 'Sphere'}], 'lights': [{'type': 'AmbientLight'}]
            glass and windows throw no shadow | 'scene': [{'type': 'Sphere', 'surface': {'type': 'Refractive'}}] \
            | 'scene': [{'type': 'Sphere'}]
            Ambient light is the same in every frame | 'scene': [{'type': 'Moving', 'velocity': [0, 0, 0.5]}], 'colours': 'doppler' \
            | 'scene': [{'type': 'Sphere'}], 'velocity': [0, 0, 0.5], 'colours': 'doppler'
            no cos^4 law | | 'camera': {'type': 'PanoramicCamera'}
            nothing is blurred by motion | 'velocity': [0, 0, 0.5] | 'velocity': [0, 0, 0]
            nothing is blurred by motion | 'velocity': [0, 0, 0.5] | 'velocity': [0, 0, 0.5], 'camera': {'exposureTime': 1}
            nothing is blurred by motion | 'scene': [{'type': 'Moving'}] | 'scene': [{'type': 'Moving', 'velocity': [0, 0, 0]}]
            Measured, not a photograph: it shows where things are at the time 0 of | 'view': 'measured' | 'view': 'seen'
            where things are in the camera's frame, for each ray | 'view': 'measured', \
            'camera': {'rollingShutter': {'sweep': 1}} | 'view': 'measured'
            no searchlight effect; what is measured has no Doppler | 'view': 'measured', 'colours': 'doppler', 'velocity': [0, 0, 0.5] \
            | 'view': 'measured', 'velocity': [0, 0, 0.5]
            All light crosses the | 'velocity': [0, 0, 0.5] | 'view': 'measured', 'velocity': [0, 0, 0.5]
            """)
    void explainTellsWhatIsLeftOutWhereItMatters(String said, String with, String without) throws IOException {
        assertThat(explained(with)).contains(said);
        assertThat(explained(without)).doesNotContain(said);
    }

    /** Two velocities beside rest: what has one of them shares a frame, wherever it is. */
    @Test
    void explainTellsTheFramesAndTheFastest() throws IOException {
        String said = explained("""
                'scene': [
                  {'type': 'Sphere'},
                  {'type': 'Moving', 'velocity': [0.6, 0, 0]},
                  {'type': 'Moving', 'velocity': [0.6, 0, 0], 'place': [5, 0, 0]},
                  {'type': 'Moving', 'velocity': [0, 0.8, 0],
                   'objects': [{'type': 'Moving', 'velocity': [0.6, 0, 0]}]}],
                'lights': [{'type': 'AmbientLight'}, {'type': 'PointLight'}, {'type': 'Moving', 'velocity': [0.6, 0, 0]}]
                """);
        assertThat(said)
                .contains(
                        "4 inertial frames: each ray is searched for in every one that holds objects; the fastest moves"
                                + " with gamma 1.667.");
    }

    private String explained(String scene) throws IOException {
        String text = "{" + (scene == null ? "" : scene) + "}";
        String whole = text.replace("WINDOW", "{'type': 'Plane', 'surface': {'type': 'LorentzWindow'}}")
                .replace('\'', '"');
        return ProgramRun.of("explain", Files.writeString(folder.resolve("left.json"), whole), "--size", "8x8")
                .out();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            doppler     | lorentz  | 0.6    | shift with the Doppler factor D (frequency in the camera/scene), as in the light of a black body. The light of \
            the scene is metered in the middle of the picture, where D is 2: -3.1 stops.
            searchlight | lorentz  | 0.6    | The searchlight effect alone: brightness changes with the fourth power of the \
            Doppler factor D (frequency in the camera/scene). The light of the scene is metered in the middle of the picture, where D is 2: -4.0 stops.
            searchlight | lorentz  | 1e-12  | where D is 1: +0.0 stops.
            searchlight | lorentz  | -0.999 | Warning: the light of the scene is too faint to be seen in the middle of the picture, which stays dark.
            doppler     | galilean | 0.6    | no searchlight effect; they change under the Lorentz transformation only.
            doppler     | none     | 0.6    | no searchlight effect; they change under the Lorentz transformation only.
            doppler     | lorentz  | 0      | no Doppler shift, no searchlight effect.
            unchanged   | lorentz  | 0.6    | no Doppler shift, no searchlight effect.
            """)
    void explainTellsWhatBecomesOfColours(String colours, String law, double speed, String said) throws IOException {
        Path scene = folder.resolve("colours.json");
        Files.writeString(
                scene,
                String.format(
                        Locale.ROOT,
                        "{'colours': '%s', 'transformation': '%s', 'velocity': [0, 0, %s]}".replace('\'', '"'),
                        colours,
                        law,
                        speed));
        assertThat(ProgramRun.of("explain", scene, "--size", "8x6").out()).contains(said);
    }

    @Test
    void explainTellsThatLightIsNotMetered() throws IOException {
        Path scene = Files.writeString(
                folder.resolve("colours.json"), "{\"colours\": \"searchlight\", \"velocity\": [0, 0, 0.6]}");

        assertThat(ProgramRun.of("explain", scene, "--size", "8x6", "--set", "metering=none")
                        .out())
                .contains("The light of the scene is taken as it comes, without metering.");
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
