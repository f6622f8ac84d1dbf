package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.app.ProgramRun.FIG1B;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.explain.Explanation;
import tompkins.io.StudioReader;
import tompkins.studio.RenderSettings;
import tompkins.trace.RenderPlan;

/**
 * What {@code tompkins render} takes, and takes again to the same bytes, and what it says of scenes it cannot save
 * whole.
 */
class RenderCommandTest {

    /** Place of the bits of a channel in a PNG file. */
    private static final int PNG_BIT_DEPTH = 24;

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
            assertThat(run.out()).contains(first.toString(), ", 3 samples per pixel");

            assertThat(ProgramRun.of("render", first, "-o", second).code()).isZero();

            assertThat(Files.readAllBytes(second)).isEqualTo(Files.readAllBytes(first));
        }
    }

    @Test
    void noErrorIsClaimedWhereNothingCanBeCompared() {
        ProgramRun run =
                ProgramRun.of("render", FIG1B, "-o", folder.resolve("pixel.png"), "--size", "1x1", "--samples", 1);

        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out()).endsWith(", 1 sample per pixel)\n");
    }

    @Test
    void aPhotographOfAWantedErrorIsTakenAgainToIt() throws IOException {
        Path first = folder.resolve("first.png");
        ProgramRun run = ProgramRun.of("render", FIG1B, "-o", first, "--size", "32x24", "--error", "0.02");
        assertThat(run.code()).as(run.err()).isZero();
        Path second = folder.resolve("second.png");
        assertThat(ProgramRun.of("render", first, "-o", second).code()).isZero();
        assertThat(Files.readAllBytes(second)).isEqualTo(Files.readAllBytes(first));
        Path third = folder.resolve("third.png");
        assertThat(ProgramRun.of("render", first, "-o", third, "--samples", 2).out())
                .contains(", 2 samples per pixel");
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
    void photographsTakenAgainKeepTheirFormat(String format, String first, String again, String expected)
            throws IOException {
        Path before = folder.resolve(first);
        ProgramRun one = ProgramRun.of("render", FIG1B, "-o", before, "--size", "32x24", "--format", format);
        assertThat(one.out()).contains(", 4 samples per pixel");

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
    void scenesTooLongForAPhotographAreRefused() throws IOException {
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
            Files.writeString(
                    folder.resolve("mesh.obj"), "v 0 0 -5\nv 1 0 -5\nv 0 1 -5\nf 1 2 3\n# " + "x".repeat(size));
            Path scene = Files.writeString(folder.resolve("mesh.json"), """
                    { "settings": { "width": 8, "height": 6 }, "scene": [
                      { "type": "TriangleMesh", "mesh": "mesh.obj" }, { "type": "TriangleMesh", "mesh": "mesh.obj" }] }
                    """);

            ProgramRun run = ProgramRun.of("render", scene, "-o", folder.resolve("mesh.png"), "--force");

            assertThat(run.code()).as(run.err()).isZero();
            assertThat(run.err().lines()).hasSize(size > 1 << 20 ? 1 : 0);
            assertThat(run.err().isEmpty() || run.err().startsWith("note: keep mesh.obj in the same folder"))
                    .isTrue();
        }
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

    static Stream<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            return files.filter(file -> file.toString().endsWith(".json")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everySceneRendersWithoutWarning(Path scene) {
        ProgramRun run = ProgramRun.of("render", scene, "-o", folder, "--size", "32x24", "--samples", 2);

        assertThat(run.code()).isZero();
        assertThat(run.err()).isEmpty();
        assertThat(new Explanation(RenderPlan.of(StudioReader.read(scene))).sentences())
                .hasSizeGreaterThan(5);
    }

    /** The command says it, and so does the title in the file. */
    @Test
    void whatIsNoPhotographSaysSo() throws IOException {
        Path picture = folder.resolve("measured.png");
        ProgramRun run = ProgramRun.of(
                "render", "scenes/motion-barn-measured.json", "--size", "8x6", "--samples", "1", "-o", picture);
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out()).contains("(measured, not a photograph; ");
        assertThat(Files.readString(picture, StandardCharsets.ISO_8859_1))
                .contains("Measured, not a photograph: A rod fits into a shorter barn");
        Path seen = folder.resolve("seen.png");
        assertThat(ProgramRun.of("render", "scenes/motion-barn.json", "--size", "8x6", "--samples", "1", "-o", seen)
                        .out())
                .doesNotContain("photograph");
    }

    /** The mean of the samples is printed with three digits. */
    @Test
    void aPhotographKeepsHowManySamplesItsTimeGave() throws IOException {
        Path scene = Files.writeString(folder.resolve("noisy.json"), """
                {"settings": {"width": 32, "height": 24, "targetError": 0.5}, "camera": {"apertureRadius": 0.1},
                 "scene": [{"type": "Sphere", "centre": [0, 0, 5], "radius": 1}]}
                """);
        Path picture = folder.resolve("noisy.png");

        ProgramRun run = ProgramRun.of("render", scene, "-o", picture, "--seconds", 0.2);

        RenderSettings kept = StudioReader.read(picture).settings();
        assertThat(run.err().strip())
                .isEqualTo("note: taken again it has " + kept.samples() + " samples of each pixel");
        double mean = Double.parseDouble(run.out().replaceAll("(?s).*, ([0-9.e]+) samples per pixel.*", "$1"));
        assertThat(mean).isBetween(0.99 * kept.samples() - 1, 1.01 * kept.samples() + 1);
        assertThat(kept.samples()).isGreaterThan(8);
        assertThat(kept.targetError()).isZero();
    }
}
