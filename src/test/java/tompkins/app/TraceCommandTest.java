package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.io.StudioReader;
import tompkins.sceneobject.Group;

class TraceCommandTest {

    private static final Pattern NUMBER = Pattern.compile("-?[0-9][-+0-9.eE]*");

    @TempDir
    private Path folder;

    /** beta = (0, 0, 0.9), looking along +x: the ray runs along (0.43589, 0, -0.9) in the scene. */
    @Test
    void showsTheSignOfTheTransformation() throws IOException {
        Path scene = Files.writeString(folder.resolve("sideways.json"), """
                {
                  "velocity": [0, 0, 0.9],
                  "camera": { "viewDirection": [1, 0, 0] },
                  "settings": { "width": 1, "height": 1 },
                  "scene": [{ "type": "Plane", "point": [0, 0, -9], "normal": [0, 0, 1] }],
                }
                """);

        String json = ProgramRun.of("trace", scene, "--pixel", "0,0", "--json").out();

        assertThat(numbers(json, "camera", "direction")).containsExactly(1.0, 0.0, 0.0);
        List<Double> direction = numbers(json, "scene", "direction");
        assertThat(direction.get(0)).isCloseTo(Math.sqrt(1 - 0.81), within(1e-15));
        assertThat(direction.get(2)).isCloseTo(-0.9, within(1e-15));
        double gamma = 1 / Math.sqrt(0.19);
        assertThat(numbers(json, "gamma").get(0)).isCloseTo(gamma, within(1e-14));
        // 90 degrees in the camera frame: D = 1/gamma
        assertThat(numbers(json, "frequencyRatio").get(0)).isCloseTo(1 / gamma, within(1e-15));
        // the plane z = -9 is 10 away along a direction with z = -0.9, and light takes 10 for it
        assertThat(numbers(json, "distance").get(0)).isCloseTo(10, within(1e-13));
        assertThat(numbers(json, "hits", "time").get(0)).isCloseTo(-10, within(1e-13));
        assertThat(numbers(json, "hits", "position").get(0)).isCloseTo(10 * Math.sqrt(0.19), within(1e-13));
        assertThat(json).contains("\"object\": \"plane\"", "\"frame\": \"scene\"", "\"surface\": \"ColouredSurface\"");
    }

    /** Pixels of a picture 90 degrees and three pixels wide look 2/3 to the left of the axis, and 2/3 to the right. */
    @Test
    void severalPixelsComeInTheirOrder() throws IOException {
        Path scene = Files.writeString(folder.resolve("wall.json"), """
                {
                  "camera": { "horizontalAngleDegrees": 90, "verticalAngleDegrees": 90 },
                  "settings": { "width": 3, "height": 3 },
                  "scene": [{ "type": "Plane", "point": [0, 0, 9], "normal": [0, 0, 1] }]
                }
                """);
        String[] both = {"trace", scene.toString(), "--pixel", "0,1", "--pixel", "2,1"};

        String text = ProgramRun.of((Object[]) both).out();
        String json = ProgramRun.of("trace", scene, "--json", "--pixel", "0,1", "--pixel", "2,1")
                .out();

        assertThat(text.lines().filter(line -> line.startsWith("Pixel"))).containsExactly("Pixel 0, 1", "Pixel 2, 1");
        assertThat(text.lines().filter(line -> line.equals("Hits plane")).count())
                .isEqualTo(2);
        String first =
                ProgramRun.of("trace", scene, "--json", "--pixel", "0,1").out().strip();
        String second =
                ProgramRun.of("trace", scene, "--json", "--pixel", "2,1").out().strip();
        assertThat(json.strip()).isEqualTo("[" + first + ",\n" + second + "]");
        double left = numbers(first, "hits", "position").get(0);
        double right = numbers(second, "hits", "position").get(0);
        assertThat(Math.abs(left)).isCloseTo(6, within(1e-12));
        assertThat(left).isCloseTo(-right, within(1e-12));
    }

    @Test
    void speedsOfNewtonsWorldHaveNoLorentzFactor() throws IOException {
        Path scene = Files.writeString(folder.resolve("newton.json"), """
                { "velocity": [0, 0, 0.6], "transformation": "galilean", "settings": { "width": 1, "height": 1 } }
                """);

        ProgramRun text = ProgramRun.of("trace", scene, "--pixel", "0,0");
        ProgramRun json = ProgramRun.of("trace", scene, "--pixel", "0,0", "--json");

        assertThat(text.out()).containsPattern("\n {2}beta +0\\.6\n").doesNotContain("gamma");
        assertThat(numbers(json.out(), "beta")).containsExactly(0.6);
        assertThat(json.out()).doesNotContain("gamma");
    }

    /** Across its motion the camera keeps up with the phase of such light: (1, 0.5) has D = 1/(1 - 2 x 0.5) there. */
    @Test
    void numbersThatAreNotFiniteAreNullInJson() throws IOException {
        Path scene = Files.writeString(folder.resolve("infinite.json"), """
                {
                  "velocity": [0, 0.5, 0.5], "transformation": "galilean",
                  "settings": { "width": 1, "height": 1 },
                  "cameraFrame": [
                    { "type": "Plane", "point": [0, 0, -1], "normal": [0, 0, -1],
                      "surface": { "type": "Refractive", "indexRatio": 2 } }
                  ]
                }
                """);

        ProgramRun json = ProgramRun.of("trace", scene, "--pixel", "0,0", "--json");

        assertThat(json.code()).as(json.err()).isZero();
        assertThat(json.out()).contains("\"frequencyRatio\": null");
        // d - n beta = (0, 0, 1) - 2 (0, 0.5, 0.5)
        assertThat(numbers(json.out(), "scene", "direction")).containsExactly(0.0, -1.0, 0.0);
    }

    /** Glass of index 1.5 reflects ((1.5 - 1)/(1.5 + 1))^2 = 0.04 of the light that meets it straight. */
    @Test
    void whereTheRaySplitsItsWeakerBranchIsIndented() throws IOException {
        String plane = "{'type': 'Plane', 'normal': [0, 0, 1], 'description': ";
        String text = "{'settings': {'width': 1, 'height': 1}, 'scene': [" + plane
                + "'glass', 'point': [0, 0, 5], 'surface': {'type': 'Refractive'}}, "
                + plane + "'behind', 'point': [0, 0, -3]}, " + plane + "'ahead', 'point': [0, 0, 9]}]}";
        Path scene = Files.writeString(folder.resolve("glass.json"), text.replace('\'', '"'));

        ProgramRun told = ProgramRun.of("trace", scene, "--pixel", "0,0");
        String json = ProgramRun.of("trace", scene, "--pixel", "0,0", "--json").out();

        assertThat(told.out()
                        .lines()
                        .filter(line -> line.matches(" *(Hits|throughput) .*"))
                        .map(line -> line.replaceAll("(?<=\\S) +", " ")))
                .containsExactly(
                        "Hits glass", "  Hits behind", "    throughput 0.04", "Hits ahead", "  throughput 0.96");
        assertThat(numbers(json, "behind", "branch")).containsExactly(1.0);
        assertThat(numbers(json, "ahead", "branch")).containsExactly(0.0);
        assertThat(numbers(json, "behind", "share").get(0)).isCloseTo(0.04, within(1e-16));
    }

    /** The moments of an exposure of 4 lie 4 apart; without one named it is the middle. */
    @Test
    void momentsAreChosen() {
        assertThat(cameraTime()).isEqualTo(cameraTime("--moment", "0.5"));
        assertThat(cameraTime("--moment", "1") - cameraTime("--moment", "0")).isCloseTo(4, within(1e-12));
    }

    private static double cameraTime(String... words) {
        List<Object> all = new ArrayList<>(List.of("trace", "scenes/fig1b.json", "--pixel", "1,1", "--exposure", "4"));
        all.addAll(List.of(words));
        return ProgramRun.of(all.toArray())
                .out()
                .lines()
                .filter(line -> line.strip().startsWith("time"))
                .mapToDouble(line -> Double.parseDouble(line.replaceAll("[^-0-9.e]*time", "")))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aRayThatNeverCrossesTheShutterHasNoLife() throws IOException {
        Path scene = Files.writeString(folder.resolve("parallel.json"), """
                {
                  "camera": { "shutter": { "type": "ArbitraryPlaneShutter", "point": [1, 0, 0], "normal": [1, 0, 0] } },
                  "settings": { "width": 1, "height": 1 },
                }
                """);

        ProgramRun run = ProgramRun.of("trace", scene, "--pixel", "0,0");

        assertThat(run.code()).isZero();
        assertThat(run.out()).contains("never crosses the shutter");
        assertThat(ProgramRun.of("trace", scene, "--pixel", "0,0", "--json").out())
                .isEqualToIgnoringNewLines("null");
    }

    /** The mirror sends the ray back from z = 10 at t = -10; the wall z = -9 + 0.8 t was there 135 before. */
    @Test
    void distancesToWhatMovesAreThoseOfTheScene() throws IOException {
        Path scene = Files.writeString(folder.resolve("mirror.json"), """
                {
                  "settings": { "width": 1, "height": 1 },
                  "scene": [
                    { "type": "Plane", "description": "glass", "point": [0, 0, 10], "normal": [0, 0, 1],
                      "surface": { "type": "Mirror" } },
                    { "type": "Moving", "velocity": [0, 0, 0.8], "place": [0, 0, -9],
                      "objects": [{ "type": "Plane", "description": "wall", "point": [0, 0, 0], "normal": [0, 0, 1] }] }
                  ]
                }
                """);

        String json = ProgramRun.of("trace", scene, "--pixel", "0,0", "--json").out();

        assertThat(numbers(json, "wall", "distance").get(0)).isCloseTo(135, within(1e-10));
        // what is at rest has a rest frame, too
        assertThat(numbers(json, "glass", "own", "properTime").get(0)).isCloseTo(-10, within(1e-12));
        assertThat(numbers(json, "glass", "own", "frequencyRatio").get(0)).isEqualTo(1);
    }

    @Test
    void raysAreDrawnIntoAnotherScene() throws IOException {
        Path scene = Files.writeString(folder.resolve("ball.json"), """
                {
                  "velocity": [0, 0, 0.3],
                  "settings": { "width": 20, "height": 15 },
                  "scene": [
                    { "type": "Sphere", "surface": { "type": "Refractive", "indexRatio": 1.5 } },
                    { "type": "Plane", "point": [0, 0, 15], "normal": [0, 0, -1] }
                  ]
                }
                """);
        Path drawn = folder.resolve("drawn.json");

        ProgramRun traced = ProgramRun.of("trace", scene, "--pixel", "11,8", "--json", "--draw", drawn);

        assertThat(traced.code()).as(traced.err()).isZero();
        Group tubes = (Group) StudioReader.read(drawn).scene().get(2);
        assertThat(tubes.description()).isEqualTo("ray of pixel 11,8");
        assertThat(tubes.objects()).hasSizeGreaterThan(8);
        ProgramRun again = ProgramRun.of("trace", scene, "--pixel", "11,8", "--draw", drawn);
        assertThat(again.code()).isEqualTo(2);
        assertThat(again.err()).contains("there is a file of this name already; --force replaces it");
    }

    /** The numbers behind the last of some keys, each searched behind the one before. */
    private static List<Double> numbers(String json, String... keys) {
        int place = 0;
        for (String key : keys) {
            place = json.indexOf('"' + key + '"', place) + key.length() + 2;
            assertThat(place).as(key).isGreaterThan(key.length() + 1);
        }
        String rest = json.substring(place).replaceFirst("^\\s*:\\s*", "");
        String value = rest.startsWith("[") ? rest.substring(0, rest.indexOf(']')) : rest.split("[,\\n}]")[0];
        List<Double> numbers = new ArrayList<>();
        Matcher matcher = NUMBER.matcher(value);
        while (matcher.find()) {
            numbers.add(Double.parseDouble(matcher.group()));
        }
        return numbers;
    }
}
