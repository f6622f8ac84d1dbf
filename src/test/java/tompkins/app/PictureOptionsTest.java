package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.app.ProgramRun.FIG1B;

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
import org.junit.jupiter.params.provider.ValueSource;
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

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--beta 0,0,1 | --beta: velocity: must be shorter than 1 (the speed of light), was [0, 0, 1] with length 1",
                "--beta 0.6,0.8,0 | shorter than 1",
                "--beta 0,-.99999999999999999,0 | was [0, -1, 0] with length 1; -.99999999999999999 was rounded to 1: "
                        + "to come nearer to the speed of light, write \"gamma\" or \"oneMinusBeta\" in the velocity of a scene "
                        + "file",
                "--beta 0,0,NaN | --beta: velocity[2]: must be a finite number, was NaN",
                "--beta 1,200 | --beta: velocity: must be three numbers [x, y, z], was a list of 2 values",
                "--beta 1,2 | --beta: velocity.beta: must be at least 0 and below 1 (the speed of light), was 1.2",
                "--beta x_km/s | --beta: velocity.beta: must be a number, was \"x_km/s\"",
                "--beta 3e5km/s | --beta: velocity.beta: must be at least 0 and below 1 (the speed of light), was 1.000692",
                "--beta fast | --beta: velocity.beta: must be a number, was \"fast\"",
                "--beta 1.2 | --beta: velocity.beta: must be at least 0 and below 1 (the speed of light), was 1.2",
                "--beta 1e400 | --beta: velocity.beta: must be at least 0 and below 1 (the speed of light), was 1e400",
                "--beta -0.5 | --beta: velocity.beta: must be at least 0 and below 1 (the speed of light), was -0.5",
                "--beta .99999999999999999 | (the speed of light), was 1; .99999999999999999 was rounded to 1: to come nearer",
                "--gamma 0.9 | --gamma: velocity.gamma: must be 1 or above, was 0.9",
                "--gamma Infinity | --gamma: velocity.gamma: must be a finite number, was Infinity",
                "--gamma 1e9 | --gamma: velocity: must be at most that of gamma 1e8, was that of gamma 1e9",
                "--gamma fast | --gamma: velocity.gamma: must be a number, was \"fast\"",
                "--size 640 | --size must be two whole numbers such as 640x480, was 640",
                "--size 0x480 | --size: settings.width: must be a whole number from 1 to 65535, was 0",
                "--size 60000x60000 | --size: settings.height: must be small enough for at most 100000000 pixels, was 60000 "
                        + "(with width 60000)",
                "--size 1e20x480 | --size: settings.width: must be a whole number from 1 to 65535, was 1e20",
                "--samples 0 | --samples: settings.samples: must be a whole number from 1 to 1048576, was 0",
                "--error 2 | --error must be from 0.000001 to 1, was 2",
                "--error 0 | --error must be from 0.000001 to 1, was 0",
                "--error -1e-7 | --error must be from 0.000001 to 1, was -1e-7",
                "--error 1e400 | --error must be at most 1.7976931348623157e308, was 1e400",
                "--seconds 0 | --seconds must be from 0.01 to 1000000, was 0",
                "--samples many | --samples: settings.samples: must be a whole number, was \"many\"",
                "--samples 1.5 | --samples: settings.samples: must be a whole number, was 1.5",
                "--samples 99999999999 | must be a whole number from 1 to 1048576, was 99999999999",
                "--threads -99999999999 | --threads must be a whole number from 1 to 1024, was -99999999999",
                "--samples --force | Expected parameter for option '--samples'",
                "--error scenes/fig1b.json | --error must be a number, was scenes/fig1b.json",
                "--seconds long | --seconds must be a number, was long",
                "--time now | --time: camera.shutter.openingTime: must be a number, was \"now\"",
                "--seed 1.5 | --seed: settings.seed: must be a whole number from -2^63 to 2^63 - 1, was 1.5",
                "--seed 99999999999999999999 | --seed: settings.seed: must be a whole number from -2^63 to 2^63 - 1",
                "--threads --force | Expected parameter for option '--threads'",
                "--force=maybe --error | --force takes no value",
                "--format jpeg | --format must be one of png, png16, tiff, tiff_float, hdr, was jpeg",
                "--time NaN | --time: camera.shutter.openingTime: must be a finite number, was NaN",
                "--exposure -1 | --exposure: camera.exposureTime: must be from 0 to 1e50, was -1",
                "--exposure 1e400 | --exposure: camera.exposureTime: must be from 0 to 1e50, was 1e400",
                "--exposure long | --exposure: camera.exposureTime: must be a number, was \"long\"",
                "--time 1e51 | --time: camera.shutter.openingTime: must be from -1e50 to 1e50, was 1e51",
                "--time 0x1p3 | --time: camera.shutter.openingTime: must be a number, was \"0x1p3\"",
                "--time 3d | --time: camera.shutter.openingTime: must be a number, was \"3d\"",
                "--beta 0,0,0.5f | --beta: velocity: must be three numbers [x, y, z] in units of c",
                "--size 99999999999x4 | --size: settings.width: must be a whole number from 1 to 65535, was 99999999999",
                "--colours red | --colours: colours: must be one of unchanged, searchlight, doppler, was \"red\"",
                "--set camera.rollingShutter.sweep=NaN | --set: camera.rollingShutter.sweep: must be a finite number, was NaN",
                "--set camera.rollingShutter.sweep=-0.1 | --set: camera.rollingShutter.sweep: must be from 0 to 1e50, was -0.1",
                "--set camera.rollingShutter.direction=sideways | must be one of down, up, right, left, was \"sideways\"",
                "--set settings.toneCurve=loud | --set: settings.toneCurve: must be one of linear, srgb, was \"loud\"",
                "--set scene[7].radius=1 | --set: scene: has no part [7], only [0] to [1]",
                "--set width | --set must be PATH=VALUE, such as settings.width=320, was width",
                "--set =3 | --set must be PATH=VALUE, such as settings.width=320, was =3",
                "--set ..=3 | --set: must begin with the path of a key, such as settings.width, velocity.gamma or "
                        + "scene[0].radius, was ..",
                "--threads 0 | --threads must be a whole number from 1 to 1024, was 0",
                "--threads 1025 | --threads must be a whole number from 1 to 1024, was 1025",
                "--speed 0.5 | unknown option --speed; did you mean \"--beta\"?",
                "--sped 3 | unknown option --sped; did you mean \"--seed\"?",
                "--beta --force | Expected parameter for option '--beta'",
                "--format hdr | .hdr"
            })
    void mistakesInOptionsAreNamed(String options, String said) {
        String[] words = options.trim().split(" ");
        Path picture = folder.resolve("never.png");

        ProgramRun run = ProgramRun.of("render", FIG1B, "-o", picture, words[0], words[1]);

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains(said.trim()).doesNotContain("Exception").doesNotContain("\tat ");
        assertThat(picture).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "render --size=",
                "render --set=",
                "render --error=",
                "render --seconds=",
                "render --threads=",
                "render --format=",
                "render --part=",
                "trace --pixel=",
                "trace --pixel=1,1 --every=",
                "trace --pixel=1,1 --pupil=",
                "trace --pixel=1,1 --moment=",
                "measure line --pixel=9,9 --pixel="
            })
    void emptyValuesAreShown(String command) {
        ProgramRun run = ProgramRun.of((Object[]) (command + " " + FIG1B).split(" "));

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains(", was \"\"");
    }

    /** gamma = 1.25 belongs to beta = 0.6. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "[0, 0, 0] | 0 | 0.6",
                "[0, 0, 0.1] | 0 | 0.6",
                "[0.3, 0, 0.4] | 0.36 | 0.48",
                "[-0.5, 0, 0] | -0.6 | 0",
                "{\"beta\": 0, \"direction\": [2, 0, 0]} | 0.6 | 0",
                "{\"gamma\": 1, \"direction\": [-3, 0, 4]} | -0.36 | 0.48"
            })
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

    @Test
    void onlyOneVelocityMayBeGiven() {
        ProgramRun run = ProgramRun.of("render", FIG1B, "-o", folder.resolve("a.png"), "--beta=0,0,0.5", "--gamma=2");

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err())
                .startsWith("tompkins render: --beta=B|X,Y,Z, --gamma=G are mutually exclusive (specify only one)");
        assertThat(folder).isEmptyDirectory();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "--samples 4 --error",
                "--samples 4 --seconds 1",
                "--samples 4 --samples 5",
                "--error 0.1 --seconds 1"
            })
    void onlyOneWishForTheQualityMayBeGiven(String wishes) {
        Path picture = folder.resolve("never.png");
        for (String command : new String[] {"render", "explain"}) {
            List<Object> words = new ArrayList<>(List.of(command, FIG1B));
            if (command.equals("render")) {
                words.addAll(List.of("-o", picture));
            }
            words.addAll(List.of(wishes.split(" ")));

            ProgramRun run = ProgramRun.of(words.toArray());

            assertThat(run.code()).isEqualTo(2);
            assertThat(run.out()).isEmpty();
            assertThat(run.err().lines()).hasSize(2);
            assertThat(run.err()).contains("only one").doesNotContain("[--");
            assertThat(picture).doesNotExist();
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

    @Test
    void shutterWithoutOpeningTimeTakesNone() {
        ProgramRun run =
                ProgramRun.of("explain", FIG1B, "--set=camera.shutter.type=FixedPointSurfaceShutter", "--time", 3);

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err().strip())
                .isEqualTo("--time: camera.shutter: unknown key \"openingTime\"; allowed are type");
        assertThat(ProgramRun.of("explain", FIG1B, "--time", 0).code()).isZero();
    }
}
