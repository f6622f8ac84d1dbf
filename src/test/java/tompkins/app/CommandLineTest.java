package tompkins.app;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class CommandLineTest {

    /** Place of the bits of a channel in a PNG file. */
    private static final int PNG_BIT_DEPTH = 24;

    private static final String FIG1B = "scenes/fig1b.json";

    @TempDir
    private Path folder;

    @Test
    void renderingASavedPhotographGivesTheSameBytes() throws IOException {
        for (String name : new String[] {"first.png", "first.tif", "first.hdr"}) {
            Path first = folder.resolve(name);
            Path second = folder.resolve("again-" + name);
            ProgramRun run = ProgramRun.of(
                    "render", FIG1B, "-o", first, "--size", "64x48", "--samples", 3, "--beta", "0,0.3,0.5");
            assertThat(run.code()).as(run.err()).isZero();
            assertThat(run.out()).contains(first.toString(), ", 3 samples a pixel");

            assertThat(ProgramRun.of("render", first, "-o", second).code()).isZero();

            assertThat(Files.readAllBytes(second)).isEqualTo(Files.readAllBytes(first));
        }
    }

    @ParameterizedTest
    @CsvSource({
        "png16, first.png, again.png, png16",
        "tiff_float, first.tif, again.tiff, tiff_float",
        "tiff, first.tif, again.tif, tiff",
        "hdr, first.hdr, again.pic, hdr",
        "tiff_float, first.tif, again.png, png",
        "png16, first.png, again.tif, tiff"
    })
    void aPhotographThatIsTakenAgainKeepsItsFormatWhereItsNameAllows(
            String format, String first, String again, String expected) throws IOException {
        Path before = folder.resolve(first);
        ProgramRun one = ProgramRun.of("render", FIG1B, "-o", before, "--size", "32x24", "--format", format);
        assertThat(one.out()).contains(", 1 sample a pixel");

        ProgramRun run = ProgramRun.of("render", before, "-o", folder.resolve(again));

        assertThat(run.code()).as(run.err()).isZero();
        Path wanted = folder.resolve("wanted-" + again);
        ProgramRun.of("render", FIG1B, "-o", wanted, "--size", "32x24", "--format", expected);
        assertThat(Files.readAllBytes(folder.resolve(again))).isEqualTo(Files.readAllBytes(wanted));
        ProgramRun other = ProgramRun.of("render", before, "-o", folder.resolve("plain.png"), "--format", "png");
        assertThat(other.code()).isZero();
        assertThat(Files.readAllBytes(folder.resolve("plain.png"))[PNG_BIT_DEPTH])
                .isEqualTo((byte) 8);
    }

    @Test
    void aSceneThatIsTooLongForAPhotographIsRefusedBeforeItIsRendered() throws IOException {
        Path scene = Files.writeString(
                folder.resolve("long.json"),
                "{ \"remarks\": \"" + "many words ".repeat(1_600_000)
                        + "\", \"settings\": { \"width\": 5000, \"height\": 5000, \"samples\": 1000000 } }");

        ProgramRun run = ProgramRun.of("render", scene, "-o", folder.resolve("never.png"));

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err().lines()).hasSize(1);
        assertThat(run.err()).contains("long.json: the scene must be at most 16777216 characters long");
        assertThat(folder.resolve("never.png")).doesNotExist();
    }

    @Test
    void aMeshThatIsTooLargeToTravelInsideIsNamedInANote() throws IOException {
        for (int size : new int[] {1 << 10, 2 << 20}) {
            Files.writeString(folder.resolve("mesh.obj"), "v 0 0 5\nv 1 0 5\nv 0 1 5\nf 1 2 3\n# " + "x".repeat(size));
            Path scene = Files.writeString(folder.resolve("mesh.json"), """
                    { "settings": { "width": 8, "height": 6 }, "scene": [
                      { "type": "TriangleMesh", "mesh": "mesh.obj" }, { "type": "TriangleMesh", "mesh": "mesh.obj" }] }
                    """);

            ProgramRun run = ProgramRun.of("render", scene, "-o", folder.resolve("mesh.png"), "--force");

            assertThat(run.code()).as(run.err()).isZero();
            assertThat(run.err().lines()).hasSize(size > 1 << 20 ? 1 : 0);
            assertThat(run.err().isEmpty() || run.err().startsWith("note: the photograph names mesh.obj,"))
                    .isTrue();
        }
    }

    @Test
    @Timeout(60)
    void placesThatCannotBeWrittenAreMistakesAndRefusedBeforeThePictureIsTaken() throws IOException {
        Path missing = folder.resolve("no");
        assertThat(refusalOf(missing.resolve("picture.png"))).isEqualTo("there is no folder " + missing);
        assertThat(folder).isEmptyDirectory();

        Path file = Files.writeString(folder.resolve("file"), "no folder");
        assertThat(refusalOf(file.resolve("picture.png"))).isEqualTo("there is no folder " + file);

        Path closed = Files.createDirectory(folder.resolve("closed"));
        closed.toFile().setWritable(false);
        // the administrator may write everywhere but into the kernel's own folder, which has its own words for it
        boolean administrator = Files.isWritable(closed);
        Path locked = administrator ? Path.of("/sys") : closed;
        assertThat(refusalOf(locked.resolve("picture.png")))
                .isEqualTo(administrator ? "Operation not permitted" : "there is no permission");
    }

    @Test
    @Timeout(60)
    void aNameThatIsTooLongForTheDiskIsRefusedBeforeThePictureIsTaken() {
        assertThat(refusalOf(folder.resolve("x".repeat(300) + ".png"))).isEqualTo("File name too long");
        assertThat(folder).isEmptyDirectory();
    }

    /** Why no picture can be written there. */
    private static String refusalOf(Path picture) {
        // would take hours
        ProgramRun run = ProgramRun.of("render", FIG1B, "-o", picture, "--samples", 1 << 20);

        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err()).startsWith(picture + ": cannot be written: ");
        return run.err().strip().substring((picture + ": cannot be written: ").length());
    }

    @Test
    void numberOfThreadsDoesNotChangeTheBytes() throws IOException {
        byte[] expected = null;
        for (int threads : new int[] {1, 2, 7}) {
            Path picture = folder.resolve(threads + ".png");
            ProgramRun.of(
                    "render",
                    "scenes/fig3a.json",
                    "-o",
                    picture,
                    "--size",
                    "96x72",
                    "--samples",
                    4,
                    "--threads",
                    threads);
            byte[] bytes = Files.readAllBytes(picture);
            assertThat(bytes).isEqualTo(expected == null ? bytes : expected);
            expected = bytes;
        }
    }

    @Test
    void optionsChangeThePicture() throws IOException {
        Path plain = folder.resolve("plain.png");
        ProgramRun.of("render", "scenes/fig3a.json", "-o", plain, "--size", "64x48", "--samples", 2);
        String[][] changes = {
            {"--beta", "0,0,0.5"},
            {"--time", "1.3"},
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
                "--beta 0,-.99999999999999999,0 | was [0, -1, 0] with length 1; -.99999999999999999 was rounded to 1",
                "--beta 0,0,NaN | 3 numbers with commas between them, such as --beta=0,0,0.9, was 0,0,NaN",
                "--beta 1,2 | 3 numbers with commas between them, such as --beta=0,0,0.9, was 1,2",
                "--size 640 | 640x480",
                "--size 0x480 | --size 0x480: width must be a whole number from 1 to 65535, was 0",
                "--size 60000x60000 | 100000000 pixels",
                "--samples 0 | --samples must be a whole number from 1 to 1048576, was 0",
                "--error 2 | --error must be from 0.000001 to 1, was 2",
                "--error -1e-7 | --error must be from 0.000001 to 1, was -1e-7",
                "--seconds 0 | --seconds must be from 0.01 to 1000000, was 0",
                "--samples many | --samples must be a whole number, such as --samples=8, was many",
                "--samples 1.5 | --samples must be a whole number, such as --samples=8, was 1.5",
                "--samples 99999999999 | --samples must be smaller, was 99999999999",
                "--threads -99999999999 | --threads must be larger, was -99999999999",
                "--samples --force | --samples needs a whole number, such as --samples=8",
                "--error scenes/fig1b.json | --error must be a number, such as --error=0.002, was scenes/fig1b.json; "
                        + "without a number it must come after SCENE",
                "--seconds long | --seconds must be a number, such as --seconds=0.5, was long",
                "--time now | --time must be a number, such as --time=0.5, was now",
                "--seed 1.5 | --seed must be a whole number, such as --seed=8, was 1.5",
                "--seed 99999999999999999999 | from -9223372036854775808 to 9223372036854775807",
                "--threads --force | --threads needs a whole number, such as --threads=8",
                "--force=maybe --error | --force is given without a value, was maybe",
                "--format jpeg | --format must be one of png, png16, tiff, tiff_float, hdr, was jpeg",
                "--shutter rolling | aperture-plane",
                "--time NaN | --time must be a finite number, was NaN",
                "--threads 0 | --threads must be a whole number from 1 to 1024, was 0",
                "--threads 1025 | --threads must be a whole number from 1 to 1024, was 1025",
                "--tone loud | --tone must be one of linear, srgb, was loud",
                "--speed 3 | unknown option --speed; did you mean \"--seed\"?",
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

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "scenes/fig1b.json | --samples 1 | One sample for each pixel, in its centre.",
                "scenes/fig1b.json | --samples 5 | 5 samples for each pixel, spread evenly over the pixel.",
                "scenes/fig3a.json | --samples 5 | 5 samples for each pixel, spread evenly over pixel and lens.",
                "scenes/fig1b.json | --error 0.25 | until the estimated error is 0.25.",
                "scenes/fig3a.json | --seconds 1 | spread evenly over pixel and lens, until 1 s are over."
            })
    void explainTellsOfTheSamplesThatAreTaken(String scene, String wish, String said) {
        String[] words = wish.split(" ");

        String out = ProgramRun.of("explain", scene, words[0], words[1]).out();

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
        assertThat(run.err()).startsWith(wish.substring(0, wish.indexOf('=')) + " must be ");
        assertThat(run.err().lines()).hasSize(1);
    }

    /** What happens without a display. */
    @Test
    void photographOfTheSameSceneIsReplacedAndNothingElse() throws Exception {
        Path scene =
                Files.writeString(folder.resolve("mine.json"), "{ \"settings\": { \"width\": 8, \"height\": 6 } }");
        Path target = folder.resolve("mine.png");
        Photographer photographer = new Photographer(new CommandLine(new TompkinsCommand()), 1);

        photographer.takeDefault(scene, folder);
        FileTime first = FileTime.fromMillis(0);
        Files.setLastModifiedTime(target, first);
        photographer.takeDefault(scene, folder);
        assertThat(Files.getLastModifiedTime(target)).isGreaterThan(first);

        ProgramRun.of("render", FIG1B, "-o", target, "--size", "8x6", "--force");
        byte[] other = Files.readAllBytes(target);
        assertThatThrownBy(() -> photographer.takeDefault(scene, folder))
                .isInstanceOf(MistakeException.class)
                .hasMessageStartingWith(target + ": there is a file of this name already, and it is no photograph of ");
        assertThat(Files.readAllBytes(target)).isEqualTo(other);

        Files.writeString(target, "no picture at all");
        assertThatThrownBy(() -> photographer.takeDefault(scene, folder)).isInstanceOf(MistakeException.class);
        assertThat(target).hasContent("no picture at all");
    }

    @Test
    void shutterWithoutOpeningTimeTakesNone() {
        ProgramRun run = ProgramRun.of("explain", FIG1B, "--shutter", "fixed-point-surface", "--time", 3);

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err().strip()).isEqualTo("--time: the fixed-point-surface shutter has no opening time");
        assertThat(ProgramRun.of("explain", FIG1B, "--time", 0).code()).isZero();
    }

    @Test
    void explainSaysWhatThereIsToSee() {
        assertThat(ProgramRun.of("explain", FIG1B).out().lines().skip(1))
                .first(as(InstanceOfAssertFactories.STRING))
                .startsWith("The same moment and the same place as Fig. 1(a)");
    }

    /** Beyond a window a ray goes on from where it left it, which differs from pixel to pixel. */
    @ParameterizedTest
    @CsvSource({"scenes/fig1b.json, true", "scenes/surface-lorentz-window.json, false"})
    void onlyABarePinholeKeepsItsPointOfView(String scene, boolean keeps) {
        assertThat(ProgramRun.of("explain", scene).out().contains("the point of view does not"))
                .isEqualTo(keeps);
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
            assertThat(out).contains(warns ? "so that " + warning : "as far as its rays cross the shutter");
        }
    }

    /** Straight behind the pinhole of a panoramic camera all pixels have the same time. */
    @Test
    void explainPromisesNoDifferentPlacesWhereThereMayBeOne() throws IOException {
        Path scene = Files.writeString(folder.resolve("panorama.json"), """
                { "velocity": [0, 0, 0.5],
                  "camera": { "type": "PanoramicCamera", "shutter": { "type": "DetectorPlaneShutter" } } }
                """);

        assertThat(ProgramRun.of("explain", scene, "--size", "8x6").out())
                .contains("different pixels may see the scene from different places");
    }

    @Test
    void thePlaceOfAPictureIsToldWithoutDetours() throws IOException {
        Path inner = Files.createDirectory(folder.resolve("inner"));
        Path detour = inner.resolve("..").resolve(".").resolve("short.png");

        ProgramRun run = ProgramRun.of("render", FIG1B, "--size", "8x6", "-o", detour);

        assertThat(run.out()).startsWith(folder.resolve("short.png") + "  (");
        Files.createSymbolicLink(folder.resolve("link"), Files.createDirectory(inner.resolve("deep")));
        ProgramRun throughLink = ProgramRun.of(
                "render",
                FIG1B,
                "--size",
                "8x6",
                "-o",
                folder.resolve("link").resolve("..").resolve("linked.png"));
        assertThat(inner.resolve("linked.png")).exists();
        assertThat(throughLink.out())
                .doesNotStartWith(folder.resolve("linked.png").toString());
    }

    @Test
    void explainReadsWellForAnEmptyScene() throws IOException {
        Path empty = Files.writeString(folder.resolve("empty.json"), "{}");

        String out = ProgramRun.of("explain", empty).out();

        assertThat(out).contains("The scene holds no objects").doesNotContain("primitive");
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
                                + " no mistakes: render takes the picture again");
        Path again = folder.resolve("again.png");
        ProgramRun.of("render", cut, "-o", again);
        assertThat(Files.readAllBytes(again)).isEqualTo(bytes);
    }

    @Test
    void checkWarnsOfLostDigits() throws IOException {
        Path fast = Files.writeString(folder.resolve("fast.json"), "{ \"velocity\": { \"gamma\": 1e7 } }");

        ProgramRun run = ProgramRun.of("check", fast, FIG1B);

        assertThat(run.code()).isZero();
        assertThat(run.out().lines()).hasSize(2);
        // 8 gamma u = 8 x 1e7 x 1.1e-16
        assertThat(run.err().strip())
                .isEqualTo(fast + ": warning: gamma 1.00e+07 is above 1e+06; directions may be wrong by more than"
                        + " 9e-09 radians");
    }

    @Test
    void aWordThatIsNeitherCommandNorFileIsRefused() {
        ProgramRun run = ProgramRun.of("rendr");

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.out()).isEmpty();
        assertThat(run.err().lines()).hasSize(1);
        assertThat(run.err()).startsWith("rendr: ").contains("command", "render, check, explain, trace, study");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "rendr | rendr: there is neither a file nor a command of this name; the commands are render, check, "
                        + "explain, trace, study, help; did you mean \"render\"?",
                "foo | the commands are render, check, explain, trace, study",
                "foo bar | foo: there is neither a file nor a command of this name; the commands are",
                "rendr --size 4x4 scenes/fig1b.json | rendr: there is neither a file nor a command of this name",
                "--size 4x4 scenes/fig1b.json | --size is an option of render, explain, trace; write the command before it",
                "scenes/fig1b.json --beta=0,0,0 | --beta is an option of render, explain, trace",
                "README.md more words | tompkins: too many arguments: more words",
                "-x | tompkins: unknown option -x",
                "study tree a b | tompkins study: too many arguments: b"
            })
    void wordsThatMeanNothingAreNamedWithWhatThereIs(String line, String said) {
        ProgramRun run = ProgramRun.of((Object[]) line.trim().split(" "));

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.out()).isEmpty();
        assertThat(run.err()).contains(said.trim()).doesNotContain("Did you mean", "Unmatched");
        assertThat(run.err().contains("did you mean")).isEqualTo(line.startsWith("rendr"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"%s", "%s more words", "check %s", "render scenes/fig1b.json -o %s", "study tree -o %s"})
    void aNameThatNoFileCanHaveIsShownWithoutItsControlCharacters(String line) {
        Object[] words = line.replace("%s", "a\0b\u001b\u009bc").split(" ");

        ProgramRun run = ProgramRun.of(words);

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.out()).isEmpty();
        assertThat(run.err().lines().findFirst().orElseThrow()).endsWith(": a?b??c: no file can have this name");
    }

    @Test
    void anExistingFileIsKept() throws IOException {
        Path picture = Files.writeString(folder.resolve("mine.png"), "mine");

        ProgramRun run = ProgramRun.of("render", FIG1B, "-o", picture, "--size", "8x6");

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("mine.png").contains("--force");
        assertThat(Files.readString(picture)).isEqualTo("mine");
        assertThat(ProgramRun.of("render", FIG1B, "-o", picture, "--size", "8x6", "--force")
                        .code())
                .isZero();
        assertThat(Files.size(picture)).isGreaterThan(100);
    }

    @Test
    void allScenesAreLookedAtBeforeTheFirstPictureIsTaken() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.json"), "{ \"title\": 3 }");
        Path pictures = Files.createDirectory(folder.resolve("pictures"));

        ProgramRun run = ProgramRun.of("render", FIG1B, broken, "-o", pictures, "--size", "8x6");

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.out()).isEmpty();
        assertThat(run.err().strip()).isEqualTo(broken + ":1:12: title: must be a text in quotes, was 3");
        assertThat(pictures).isEmptyDirectory();
    }

    @Test
    void twoScenesOfOneNameDoNotReplaceEachOther() throws IOException {
        Path other = Files.copy(Path.of("scenes/fig1a.json"), folder.resolve("fig1b.json"));
        Path pictures = Files.createDirectory(folder.resolve("pictures"));

        ProgramRun run = ProgramRun.of("render", FIG1B, other, "-o", pictures, "--size", "8x6", "--force");

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err().strip())
                .isEqualTo(other + ": its picture would be " + pictures.resolve("fig1b.png") + ", as that of " + FIG1B
                        + "; render one of them alone, with another name after -o");
        assertThat(pictures).isEmptyDirectory();
    }

    @Test
    void endingsOfNamesAreChecked() {
        ProgramRun run = ProgramRun.of("render", FIG1B, "-o", folder.resolve("picture.bmp"));

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("picture.bmp").contains(".png or .tif or .tiff or .hdr or .pic");
    }

    @Test
    void anEndingAloneIsNoNameEvenForAPhotographThatIsTakenAgain() {
        Path photograph = folder.resolve("photograph.png");
        ProgramRun.of("render", FIG1B, "-o", photograph, "--size", "8x6");
        Path nameless = folder.resolve(".png");
        Object[][] ways = {{FIG1B}, {photograph}, {FIG1B, "--format", "png16"}};
        for (Object[] way : ways) {
            List<Object> words = new ArrayList<>(List.of("render", "-o", nameless, "--size", "8x6"));
            words.addAll(List.of(way));

            ProgramRun run = ProgramRun.of(words.toArray());

            assertThat(run.code()).isEqualTo(2);
            assertThat(run.out()).isEmpty();
            assertThat(run.err()).startsWith(nameless + ": the name of a").contains(" is missing before the ending");
            assertThat(folder).isDirectoryNotContaining(file -> !file.equals(photograph));
        }
    }

    @Test
    void aMissingSceneIsNamed() {
        for (String command : new String[] {"render", "check", "explain"}) {
            ProgramRun run = ProgramRun.of(command, "scenes/no-such.json");
            assertThat(run.code()).isEqualTo(2);
            assertThat(run.err()).contains("no-such.json").doesNotContain("\tat ");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "render", "check", "explain"})
    void theRootOfAllFoldersIsNoScene(String command) {
        ProgramRun run = command.isEmpty() ? ProgramRun.of("/") : ProgramRun.of(command, "/");

        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err().strip())
                .endsWith(Path.of("/") + ": is a folder; a scene file or a saved photograph is needed");
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

    static Stream<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            return files.filter(file -> file.toString().endsWith(".json")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everySceneRendersWithoutWarning(Path scene) {
        ProgramRun run = ProgramRun.of("render", scene, "-o", folder, "--size", "48x36", "--samples", 2);

        assertThat(run.code()).isZero();
        assertThat(run.err()).isEmpty();
        assertThat(ProgramRun.of("explain", scene, "--size", "48x36").out()).contains("camera");
    }

    @Test
    void explainSaysExactlyHowManySamplesAPictureHas() {
        String one = ProgramRun.of("explain", "scenes/smallest.json", "--size", "100x70")
                .out();
        assertThat(one).contains("with 7000 samples, 1 for each pixel.");
        String many = ProgramRun.of("explain", "scenes/smallest.json", "--size", "200x300", "--samples", 64)
                .out();
        assertThat(many).contains("with 3.84 million samples, 64 for each pixel.");
    }

    /** The time is written without a power of ten, however long it is. */
    @Test
    void explainSaysHowLongAWantedErrorTakes() {
        String out = ProgramRun.of("explain", "scenes/smallest.json", "--size", "100x70", "--error", "0.00001")
                .out();
        assertThat(out)
                .containsPattern("it will take about [0-9.]+ s with [0-9.]+( million)? samples, [0-9.]+ for each");
    }

    /** Light that is split at each of 90 spheres: no block of pixels ends soon. */
    @ParameterizedTest
    @CsvSource({"scene, about [0-9.]+ s with", "cameraFrame, too long to foretell: .* not one sample was complete"})
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

    @Test
    void severalScenesGoIntoAFolder() {
        assertThat(ProgramRun.of("render", FIG1B, "scenes/fig1a.json", "-o", folder, "--size", "8x6")
                        .code())
                .isZero();
        assertThat(folder.resolve("fig1a.png")).exists();
        assertThat(folder.resolve("fig1b.png")).exists();
        ProgramRun run = ProgramRun.of("render", FIG1B, "scenes/fig1a.json", "-o", folder.resolve("one.png"));
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("folder");
    }

    /** What a run prints, without its line ends. */
    private static String words(ProgramRun run) {
        return run.out().replaceAll("\\s+", " ");
    }

    @Test
    void helpAndVersion() {
        assertThat(ProgramRun.of("--help").out()).contains("render", "check", "explain", "trace");
        for (String command : new String[] {"render", "check", "explain", "trace"}) {
            ProgramRun run = ProgramRun.of(command, "--help");
            assertThat(run.code()).isZero();
            assertThat(run.out()).contains("SCENE");
        }
        assertThat(words(ProgramRun.of("render", "--help")))
                .contains("model of the shutter: aperture-plane, detector-plane, lens-hologram,"
                        + " focus-surface, arbitrary-plane, fixed-point-surface");
        assertThat(words(ProgramRun.of("study", "--help")))
                .contains("NAME aperture, antialiasing, precision, tree, depth, preview, stability, all");
        assertThat(ProgramRun.of("--version").out()).contains("Tompkins");
        assertThat(ProgramRun.of("rendr", FIG1B).code()).isEqualTo(2);
    }
}
