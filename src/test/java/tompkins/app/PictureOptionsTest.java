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
            {"--sweep", "0.2"},
            {"--shutter", "focus-surface"},
            {"--seed", "5"},
            {"--samples", "3"},
            {"--tone", "srgb"},
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
                "--beta 0,0,1 | --beta must be shorter than 1",
                "--beta 0.6,0.8,0 | shorter than 1",
                "--beta 0,-.99999999999999999,0 | was [0, -1, 0] with length 1; -.99999999999999999 was rounded to 1: "
                        + "to come nearer to the speed of light, write \"gamma\" or \"oneMinusBeta\" in the velocity of a scene "
                        + "file, or --gamma",
                "--beta 0,0,NaN | such as --beta=0.9 or --beta=0,0,0.9, was 0,0,NaN",
                "--beta 1,200 | --beta must be 1 or 3 numbers with commas between them, such as --beta=0.9 or "
                        + "--beta=0,0,0.9, was 1,200",
                "--beta 1,2 | --beta must be at least 0 and below 1 (the speed of light), was 1.2",
                "--beta x_km/s | --beta must be 1 or 3 numbers with commas between them, such as --beta=0.9 or "
                        + "--beta=0,0,0.9, was x_km/s",
                "--beta 3e5km/s | --beta must be at least 0 and below 1 (the speed of light), was 1.000692",
                "--beta fast | --beta=0.9 or --beta=0,0,0.9, was fast",
                "--beta 1.2 | --beta must be at least 0 and below 1 (the speed of light), was 1.2",
                "--beta -0.5 | --beta must be at least 0 and below 1 (the speed of light), was -0.5",
                "--beta .99999999999999999 | (the speed of light), was 1; .99999999999999999 was rounded to 1: to come nearer",
                "--gamma 0.9 | --gamma must be from 1 to 100000000, was 0.9",
                "--gamma Infinity | --gamma must be from 1 to 100000000, was Infinity",
                "--gamma 1e9 | --gamma must be from 1 to 100000000, was 1e9",
                "--gamma fast | --gamma must be a number, such as --gamma=1.5, was fast",
                "--size 640 | 640x480",
                "--size 0x480 | --size 0x480: width must be a whole number from 1 to 65535, was 0",
                "--size 60000x60000 | 100000000 pixels",
                "--samples 0 | --samples must be a whole number from 1 to 1048576, was 0",
                "--error 2 | --error must be from 0.000001 to 1, was 2",
                "--error -1e-7 | --error must be from 0.000001 to 1, was -1e-7",
                "--seconds 0 | --seconds must be from 0.01 to 1000000, was 0",
                "--samples many | --samples must be a whole number, such as --samples=8, was many",
                "--samples 1.5 | --samples must be a whole number, such as --samples=8, was 1.5",
                "--samples 99999999999 | --samples must be a whole number from 1 to 1048576, was 99999999999",
                "--threads -99999999999 | --threads must be a whole number from 1 to 1024, was -99999999999",
                "--samples --force | --samples needs a whole number, such as --samples=8",
                "--error scenes/fig1b.json | --error must be a number, such as --error=0.002, was scenes/fig1b.json; "
                        + "without a number it must come after SCENE",
                "--seconds long | --seconds must be a number, such as --seconds=1.5, was long",
                "--time now | --time must be a number, such as --time=1.5, was now",
                "--seed 1.5 | --seed must be a whole number, such as --seed=8, was 1.5",
                "--seed 99999999999999999999 | from -9223372036854775808 to 9223372036854775807",
                "--threads --force | --threads needs a whole number, such as --threads=8",
                "--force=maybe --error | --force is given without a value, was maybe",
                "--format jpeg | --format must be one of png, png16, tiff, tiff_float, hdr, was jpeg",
                "--shutter rolling | aperture-plane",
                "--time NaN | --time must be from -1e50 to 1e50, was NaN",
                "--exposure -1 | --exposure must be from 0 to 1e50, was -1",
                "--exposure long | --exposure must be a number, such as --exposure=1.5, was long",
                "--sweep NaN | --sweep must be from 0 to 1e50, was NaN",
                "--sweep -0.1 | --sweep must be from 0 to 1e50, was -0.1",
                "--rolling sideways | --rolling must be one of down, up, right, left, was sideways",
                "--time 1e51 | --time must be from -1e50 to 1e50, was 1e51",
                "--time 0x1p3 | --time must be a number",
                "--time 3d | --time must be a number",
                "--beta 0,0,0.5f | --beta must be 1 or 3 numbers",
                "--size 99999999999x4 | --size must be two whole numbers from 1 to 65535",
                "--threads 0 | --threads must be a whole number from 1 to 1024, was 0",
                "--threads 1025 | --threads must be a whole number from 1 to 1024, was 1025",
                "--tone loud | --tone must be one of linear, srgb, was loud",
                "--speed 0.5 | unknown option --speed; did you mean \"--beta\"?",
                "--sped 3 | unknown option --sped; did you mean \"--seed\"?",
                "--beta --force | --beta needs B|X,Y,Z: speed of the camera",
                "--shutter --force | --shutter needs NAME: model of the shutter: aperture-plane, detector-plane, ",
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
        assertThat(run.err()).startsWith("tompkins render: only one of --beta, --gamma may be given, and only once");
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
            assertThat(run.err()).contains("only one of --samples, --error, --seconds may be given");
            assertThat(picture).doesNotExist();
        }
    }

    @Test
    void shutterWithoutOpeningTimeTakesNone() {
        ProgramRun run = ProgramRun.of("explain", FIG1B, "--shutter", "fixed-point-surface", "--time", 3);

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err().strip()).isEqualTo("--time: the fixed-point-surface shutter has no opening time");
        assertThat(ProgramRun.of("explain", FIG1B, "--time", 0).code()).isZero();
    }
}
