package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.image.PhotographFile;
import tompkins.io.StudioReader;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

class AnimateCommandTest {

    @TempDir
    private Path folder;

    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("ball.json"), """
                {
                  "velocity": { "beta": 0.2, "direction": [0, 0, 1] },
                  "scene": [{ "type": "Sphere", "centre": [0, 0, 5], "radius": 1.5 }],
                  "settings": { "width": 32, "height": 24, "samples": 1 }
                }
                """);
    }

    private ProgramRun animate(String output, Object... more) {
        return ProgramRun.of(List.of("animate", scene, "-o", folder.resolve(output), "--duration", "0.2"), more);
    }

    private List<Studio> moments(String frames) {
        return IntStream.range(0, 5)
                .mapToObj(i -> StudioReader.read(folder.resolve(frames + "/frame000" + i + ".png")))
                .toList();
    }

    /** Its front at z = 5 + beta t - 1 is seen straight ahead at the age 4/(1 + beta). */
    @Test
    void theVelocityOfWhatMovesRuns() throws IOException {
        Files.writeString(scene, """
                {
                  "scene": [{ "type": "Moving", "velocity": { "beta": 0, "direction": [0, 0, 1] }, "place": [0, 0, 4],
                    "objects": [{ "type": "Plane", "point": [0, 0, 0], "normal": [0, 0, 1] }] }],
                  "settings": { "width": 32, "height": 24, "samples": 1 }
                }
                """);
        ProgramRun run = animate("frames", "--number", "scene[0].velocity.beta", "--from", "0", "--to", "0.8");
        assertThat(run.err()).isEmpty();
        List<Studio> moments = moments("frames");
        for (int i = 0; i < moments.size(); i++) {
            SampleHistory middle = SampleHistory.of(RenderPlan.of(moments.get(i)), 16, 12, 0, 0);
            assertThat(middle.end().event().time()).isCloseTo(-4 / (1 + 0.2 * i), within(1e-12));
        }
        ProgramRun tooFast = animate("never", "--number", "scene[0].velocity.beta", "--from", "0", "--to", "1");
        assertThat(tooFast.code()).isEqualTo(2);
        assertThat(tooFast.err().lines()).hasSize(1);
        assertThat(folder.resolve("never")).doesNotExist();
    }

    /** From rest, for one unit of proper time at a = 1: 0.2 s are five steps, of a rapidity of 0.2 each. */
    @Test
    void recordedRideIsTaken() throws IOException {
        Files.writeString(scene, """
                {
                  "scene": [{ "type": "Sphere", "centre": [0, 0, 5], "radius": 1.5 }],
                  "ride": [{ "seconds": 2, "properTime": 1, "acceleration": [0, 0, 1] }],
                  "settings": { "width": 32, "height": 24, "samples": 1 }
                }
                """);
        ProgramRun run = animate("frames", "--ride");
        assertThat(run.err()).isEmpty();
        assertThat(run.out()).contains("6 pictures");
        List<Studio> moments = moments("frames");
        for (int i = 0; i < moments.size(); i++) {
            Event lens = RenderPlan.of(moments.get(i)).middleHistory().sceneStart();
            assertThat(lens.z()).isCloseTo(Math.cosh(0.2 * i) - 1, within(1e-9));
            assertThat(lens.time()).isCloseTo(Math.sinh(0.2 * i), within(1e-9));
            assertThat(moments.get(i).ride()).isEmpty();
        }
        assertThat(animate("again", "--ride", "--from", "0").err()).contains("--from: a ride has no number");
    }

    /** Two seconds at a = 1 from (0, 0, 2), for two units of proper time; --ride before the scene is no name. */
    @Test
    void ridesAreTakenByName() throws IOException {
        Files.writeString(scene, """
                {
                  "scene": [{ "type": "Sphere", "centre": [0, 0, 9], "radius": 1.5 }],
                  "rides": [
                    { "name": "By hand" },
                    { "name": "Full thrust", "position": [0, 0, 2],
                      "legs": [{ "seconds": 2, "properTime": 2, "acceleration": [0, 0, 1] }] }
                  ],
                  "settings": { "width": 32, "height": 24, "samples": 1 }
                }
                """);
        assertThat(animate("frames", "--ride", "Full thrust").err()).isEmpty();
        List<Studio> moments = moments("frames");
        for (int i = 0; i < moments.size(); i++) {
            Event lens = RenderPlan.of(moments.get(i)).middleHistory().sceneStart();
            assertThat(lens.z()).isCloseTo(1 + Math.cosh(0.4 * i), within(1e-9));
        }
        String rides = "; its rides with legs are: Full thrust";
        assertThat(animate("none", "--ride", "By hand").err()).contains("is steered by hand and has no legs" + rides);
        assertThat(animate("none", "--ride", "full trust").err())
                .contains("--ride must be the name of a ride in", "was \"full trust\"" + rides, "did you mean");
        assertThat(animate("none", "--ride").err()).contains("no ride is recorded in", rides);
        assertThat(ProgramRun.of("animate", "--ride", scene, "-o", folder.resolve("none"))
                        .err())
                .contains("no ride is recorded in");
        assertThat(folder.resolve("none")).doesNotExist();
    }

    /** A loop of five steps does not show its beginning twice. */
    @Test
    void anyNumberRunsThereAndBack() {
        assertThat(animate("frames", "--number=scene[0].centre.z", "--from=5", "--to=10", "--back")
                        .code())
                .isZero();
        assertThat(moments("frames").stream()
                        .mapToDouble(AnimateCommandTest::depth)
                        .toArray())
                .containsExactly(new double[] {5, 7, 9, 9, 7}, within(1e-12));
    }

    private static double depth(Studio studio) {
        return ((Sphere) studio.scene().get(0)).centre().z();
    }

    @Test
    void eachPictureIsThePhotographOfItsMoment() throws IOException {
        animate("frames", "--from", "0", "--to", "0.8", "--samples", "2");
        Path photograph = folder.resolve("photograph.png");
        ProgramRun.of("render", scene, "-o", photograph, "--beta", "0.8", "--samples", "2", "--seed", "5");

        Path last = folder.resolve("frames/frame0004.png");
        assertThat(pixels(last).equals(pixels(photograph))).isTrue();
        assertThat(pixels(last).equals(pixels(folder.resolve("frames/frame0003.png"))))
                .isFalse();
        assertThat(PhotographFile.readScene(last)).isEqualTo(PhotographFile.readScene(photograph));
    }

    /** A ball of one colour before black, at one speed: its pictures differ by the noise at its edge alone. */
    @Test
    void eachPictureHasNoiseOfItsOwn() throws IOException {
        animate("film", "--from=0.2", "--to=0.2000001", "--samples=4", "--seed=7");
        assertThat(moments("film").stream().map(moment -> moment.settings().seed()))
                .containsExactly(7L, 8L, 9L, 10L, 11L);
        List<List<Integer>> pictures = pictures("film");
        assertThat(Set.copyOf(pictures)).hasSize(5);
        for (int i = 0; i < 5; i++) {
            Path again = folder.resolve("again" + i + ".png");
            ProgramRun.of("render", folder.resolve("film/frame000" + i + ".png"), "-o", again);
            assertThat(pixels(again)).isEqualTo(pictures.get(i));
        }
    }

    private List<List<Integer>> pictures(String frames) throws IOException {
        List<List<Integer>> pictures = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            pictures.add(pixels(folder.resolve(frames + "/frame000" + i + ".png")));
        }
        return pictures;
    }

    @Test
    void captionsAreWrittenIfTheyAreWanted() throws IOException {
        animate("plain", "--from", "0", "--to", "0.8", "--size", "160x120");
        animate("captioned", "--from", "0", "--to", "0.8", "--size", "160x120", "--caption");

        assertThat(pixels(folder.resolve("captioned/frame0002.png"))
                        .equals(pixels(folder.resolve("plain/frame0002.png"))))
                .isFalse();
    }

    private static List<Integer> pixels(Path picture) throws IOException {
        BufferedImage image = ImageIO.read(picture.toFile());
        int width = image.getWidth();
        return IntStream.of(image.getRGB(0, 0, width, image.getHeight(), null, 0, width))
                .boxed()
                .toList();
    }

    /** The window undoes the aberration at any speed; that it follows is the same for a single photograph. */
    @Test
    void aLorentzWindowThatHasTheVelocityOfTheCameraKeepsIt() {
        scene = Path.of("scenes/fig4.json");
        String[] small = {"--size", "16x12", "--samples", "1"};
        animate("frames", "--from", "0.1", "--to", "0.9", small[0], small[1], small[2], small[3]);
        Path photograph = folder.resolve("slow.png");
        ProgramRun.of("render", scene, "-o", photograph, "--gamma", "1.25", small[0], small[1], small[2], small[3]);

        assertThat(moments("frames").stream().map(AnimateCommandTest::windowSpeed))
                .containsExactly(0.1, 0.3, 0.5, 0.7, 0.9);
        assertThat(windowSpeed(StudioReader.read(photograph))).isCloseTo(0.6, within(1e-15));
    }

    private static double windowSpeed(Studio studio) {
        return FrontWindow.of(studio).orElseThrow().velocity().speed();
    }

    @Test
    void whatIsThereIsReplacedOnlyByForce() throws IOException {
        Path file = Files.writeString(folder.resolve("a.gif"), "mine");

        ProgramRun refused = animate("a.gif", "--from", "0", "--to", "0.8");
        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.err()).contains("a.gif: there is a file of this name already; --force replaces it");
        assertThat(file).hasContent("mine");
        assertThat(animate("a.gif", "--from", "0", "--to", "0.8", "--force").code())
                .isZero();
        assertThat(Files.size(file)).isGreaterThan(100);
    }

    /** Sideways the ball is out of the picture from some speed on. */
    @Test
    void warningsNameThePicture() {
        ProgramRun run = animate("a.gif", "--from", "0.9", "--to", "0.999", "--beta=0.5,0,0");

        assertThat(run.code()).isZero();
        assertThat(run.err().lines())
                .containsExactly(
                        "warning: frame 0 of 0-4: no ray met an object of the scene: another direction, a wider field of"
                                + " view or a lower speed may show some",
                        "warning: there are warnings about 4 other frames, too; render a single one to read" + " them");
    }

    /** Accuracy is promised up to gamma 1e6. */
    @Test
    void whatIsModelledRoughlyAtAnEndIsSaid() {
        ProgramRun fast = animate("fast.gif", "--number=velocity.gamma", "--from=2e6", "--to=3e7");
        ProgramRun faster = animate("faster.gif", "--number=velocity.gamma", "--from=2", "--to=3e7");
        ProgramRun slow = animate("slow.gif", "--number=velocity.gamma", "--from=1", "--to=1.1");

        assertThat(fast.err().lines().filter(line -> line.startsWith("warning: gamma ")))
                .hasSize(2);
        assertThat(faster.err().lines().filter(line -> line.startsWith("warning: gamma 30000000 is above 1000000")))
                .hasSize(1);
        assertThat(slow.err()).isEmpty();
    }
}
