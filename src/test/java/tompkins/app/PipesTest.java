package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenes that come from the standard input, and pictures that go to the standard output. */
class PipesTest extends ShellTest {

    private static final String SCENE = """
            {
              "scene": [{ "type": "Sphere", "centre": [0, 0, 5], "radius": 1.5 }],
              "settings": { "width": 32, "height": 24, "samples": 1 }
            }
            """;

    @BeforeEach
    void writeScene() throws IOException {
        Files.writeString(folder.resolve("ball.json"), SCENE);
    }

    /** A run whose standard input holds some bytes. */
    private static ProgramRun run(byte[] input, Object... words) {
        InputStream before = System.in;
        System.setIn(new ByteArrayInputStream(input));
        try {
            return ProgramRun.of(words);
        } finally {
            System.setIn(before);
        }
    }

    private static ProgramRun run(String input, Object... words) {
        return run(input.getBytes(StandardCharsets.UTF_8), words);
    }

    /** Nothing else reaches the standard output: the bytes are those of the file. */
    @Test
    void aPictureGoesThroughPipes() throws IOException, InterruptedException {
        ProgramRun run = ProgramShell.run(
                folder,
                "tompkins render ball.json -o file.png && tompkins render - -o - < ball.json > piped.png"
                        + " && tompkins render ball.json -o file.tif"
                        + " && tompkins render - -o - --format tiff < file.png > piped.tif");
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.err()).contains("-  (", "1 sample per pixel");
        assertThat(folder.resolve("piped.png")).hasSameBinaryContentAs(folder.resolve("file.png"));
        assertThat(folder.resolve("piped.tif")).hasSameBinaryContentAs(folder.resolve("file.tif"));
    }

    @Test
    void aPictureThatIsLostIsAFailure() throws IOException, InterruptedException {
        assumeTrue(Files.exists(Path.of("/dev/full")));
        ProgramRun full = shell("tompkins render ball.json -o - > /dev/full");
        assertThat(full.code()).isEqualTo(Failures.FAILURE);
        assertThat(full.err()).contains("standard output: cannot be written: No space left on device");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "check -",
                "trace - --pixel 16,12 --json",
                "measure between - --pixel 15,12 --pixel 17,12",
                "trace - --pixel 3,3 --set camera.shutter.openingTime=2"
            })
    void commandsReadThePipeAsTheyReadTheFile(String command) {
        ProgramRun piped = run(SCENE, (Object[]) command.split(" "));
        ProgramRun file = ProgramRun.of((Object[]) command.replace(" - ", " " + folder.resolve("ball.json") + " ")
                .replaceAll(" -$", " " + folder.resolve("ball.json"))
                .split(" "));
        assertThat(piped.code()).as(piped.err()).isZero();
        assertThat(piped.out())
                .isEqualTo(file.out().replace(folder.resolve("ball.json").toString(), "-"));
    }

    @Test
    void explainReadsThePipe() {
        assertThat(run(SCENE, "explain", "-").code()).isZero();
    }

    @Test
    void filmsAreTakenOfAPipedScene() {
        ProgramRun run =
                run(SCENE, "animate", "-", "--from=0", "--to=0.5", "--duration=0.1", "-o", folder.resolve("a.gif"));
        assertThat(run.err()).isEmpty();
        assertThat(run.code()).isZero();
    }

    @Test
    void mistakesInAPipeHaveTheirPlace() {
        ProgramRun run = run(SCENE.replace("1.5", "-1"), "check", "-");
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).startsWith("-:2:").contains("scene[0].radius: must be a finite number above 0, was -1");
        ProgramRun empty = run("", "check", "-");
        assertThat(empty.code()).isEqualTo(2);
        assertThat(empty.err()).startsWith("-:");
    }

    @Test
    void picturesThatCannotBeReadAreNamed() throws IOException {
        ByteArrayOutputStream plain = new ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(4, 3, BufferedImage.TYPE_INT_RGB), "png", plain);
        assertThat(run(plain.toByteArray(), "check", "-").err()).startsWith("-: the picture holds no scene");
        byte[] half = Arrays.copyOf(plain.toByteArray(), 40);
        assertThat(run(half, "check", "-").err()).startsWith("-: cannot be read: the file ends");
        byte[] tiff = {'I', 'I', 42, 0, 8, 0, 0, 0};
        assertThat(run(tiff, "check", "-").err()).startsWith("-: cannot be read: the file ends too early");
    }

    @Test
    void aPipedSceneHasNoNameForItsPicture() {
        for (String words : new String[] {"render -", "render - - -o a.png", "render - -o " + folder + "/"}) {
            ProgramRun run = run(SCENE, (Object[]) words.split(" "));
            assertThat(run.code()).isEqualTo(2);
            assertThat(run.err()).contains("the scene - is the standard input, which has no name for a picture");
        }
    }

    /** As in a container whose only writable place is its output. */
    @Test
    void aReadOnlyFolderForTemporaryFilesIsNotNeeded() throws IOException, InterruptedException {
        ProgramRun run = ProgramShell.run(
                folder,
                "OPTIONS=-Djava.io.tmpdir=/proc/none; tompkins render ball.json -o a.tif && tompkins render a.tif -o b.hdr"
                        + " && tompkins render - -o - < ball.json > c.png"
                        + " && tompkins animate c.png --from 0 --to 0.5 --duration 0.1 --caption -o a.gif");
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(folder.resolve("a.gif")).exists();
    }
}
