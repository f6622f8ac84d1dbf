package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.io.StudioReader;

/** Options of the commands that take or explain a picture: what they change, and how mistakes in them are named. */
class PictureOptionsTest {

    @TempDir
    private Path folder;

    @Test
    void optionsChangeThePicture() throws IOException {
        Path plain = folder.resolve("plain.png");
        ProgramRun.of("render", "scenes/fig3a.json", "-o", plain, "--size", "64x48", "--samples", 2);
        String[][] changes = {
            {"--beta", "0,0,0.5"},
            {"--gamma", "3"},
            {"--time", "1.3"},
            {"--exposure", "0.1"},
            {"--set", "camera.rollingShutter.sweep=0.2"},
            {"--set", "camera.shutter.type=FocusSurfaceShutter"},
            {"--seed", "5"},
            {"--samples", "3"},
            {"--set", "settings.toneCurve=srgb"},
            {"--size", "64x50"},
            {"--format", "png16"}
        };
        for (String[] change : changes) {
            Path changed = folder.resolve("changed.png");
            ProgramRun run = change[0].equals("--samples") || change[0].equals("--size")
                    ? ProgramRun.of("render", "scenes/fig3a.json", "-o", changed, "--force", change[0], change[1])
                    : ProgramRun.of(
                            "render",
                            "scenes/fig3a.json",
                            "-o",
                            changed,
                            "--force",
                            "--size",
                            "64x48",
                            "--samples",
                            2,
                            change[0],
                            change[1]);
            assertThat(run.code()).as(run.err()).isZero();
            assertThat(Files.readAllBytes(changed)).as(change[0]).isNotEqualTo(Files.readAllBytes(plain));
        }
    }

    /** gamma = 1.25 belongs to beta = 0.6. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"[0.3, 0, 0.4] | 0.36 | 0.48", "{\"gamma\": 1, \"direction\": [-3, 0, 4]} | -0.36 | 0.48"})
    void aSpeedKeepsTheDirection(String before, double x, double z) throws IOException {
        Path scene = Files.writeString(folder.resolve("scene.json"), "{\"velocity\": " + before + "}");
        for (String speed : new String[] {
            "--gamma=1.25",
            "--gamma=1,25",
            "--beta=0.6",
            "--beta=0,6",
            "--beta=179875.4748 km/s",
            "--beta=" + x + ",0," + z
        }) {
            Path picture = folder.resolve("fast" + speed.replace("/", " per ") + ".png");

            ProgramRun run = ProgramRun.of("render", scene, "-o", picture, "--size", "4x3", speed);

            assertThat(run.code()).as(run.err()).isZero();
            Vector3dc velocity = StudioReader.read(picture).velocity().components();
            assertThat(velocity.distance(x, 0, z)).as(speed).isLessThan(1e-15);
        }
    }

    /** A scene file of one line, so that the numbers show what was set. */
    @Test
    void everyCommandThatTakesASceneTakesOtherValues() throws IOException {
        Path scene = Files.writeString(folder.resolve("scene.json"), "{\"scene\": [{\"type\": \"Sphere\"}]}");
        String pixel = "--pixel=4,3";
        Object[][] commands = {
            {"render", scene, "-o", folder.resolve("a.png")},
            {"animate", scene, "-o", folder.resolve("b.png"), "--from=0", "--to=0.5"},
            {"check", scene},
            {"explain", scene},
            {"trace", scene, pixel},
            {"measure", "line", scene, pixel, "--pixel=5,3"}
        };
        for (Object[] command : commands) {
            List<Object> words = new ArrayList<>(List.of(command));
            words.addAll(List.of(
                    "--set", "scene[0].radius=2", "--set=scene[0].centre=[0, 0, 1]", "--set", "settings.width=0"));

            ProgramRun run = ProgramRun.of(words.toArray());

            assertThat(run.code()).isEqualTo(2);
            assertThat(run.err())
                    .as("%s", command)
                    .isEqualTo("--set: settings.width: must be a whole number from 1 to 65535, was 0\n");
        }
        ProgramRun ray = ProgramRun.of(
                "trace",
                scene,
                "--set=settings.width=9",
                "--set",
                "settings.height=7",
                pixel,
                "--set",
                "scene[0].radius=2");
        assertThat(ray.out())
                .contains("distance (scene)               8\n", "scene frame                    (0, 0, 8), time -8\n");
    }
}
