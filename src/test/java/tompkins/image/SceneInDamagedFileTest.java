package tompkins.image;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertTimeout;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Random;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.TestRun;
import tompkins.file.FileException;

class SceneInDamagedFileTest {

    private static final long SEED = 20260917;

    @TempDir
    private Path folder;

    private byte[] photograph(PictureFormat format) throws IOException {
        Path file = folder.resolve("photo" + format.endings().get(0));
        PhotographFile.write(file, Samples.random(24, 20, 1), format, ToneCurve.LINEAR, Samples.INFO, true);
        return Files.readAllBytes(file);
    }

    private Path file(byte[] content) throws IOException {
        return Files.write(folder.resolve("damaged"), content);
    }

    @ParameterizedTest
    @EnumSource
    void damageGivesOneMessageOrNone(PictureFormat format) throws IOException {
        byte[] photograph = photograph(format);
        Random random = new Random(SEED);
        int refused = 0;
        int files = Integer.getInteger("tompkins.fuzz", TestRun.cases(25, 300));
        for (int i = 0; i < files; i++) {
            Path file = file(Samples.damaged(photograph, random));
            refused += assertTimeout(Duration.ofMinutes(5), () -> messages(file));
        }
        assertThat(refused).as("seed %d", SEED).isBetween(files / 60, files - 1);
    }

    private static int messages(Path file) {
        try {
            PhotographFile.readScene(file);
            return 0;
        } catch (FileException e) {
            assertThat(e.getMessage())
                    .startsWith(file + ": ")
                    .doesNotContain("\n")
                    .doesNotContain("Exception");
            return 1;
        }
    }

    @ParameterizedTest
    @EnumSource
    void aFileThatEndsInsideTheSceneIsRefused(PictureFormat format) throws IOException {
        byte[] photograph = photograph(format);
        String text = new String(photograph, ISO_8859_1);
        int scene = text.indexOf(format.name().startsWith("TIFF") ? "{\n\t\"title\"" : "tompkins.scene");

        assertThat(scene).isPositive();
        Path cut = file(Arrays.copyOf(photograph, scene + 30));
        assertThatThrownBy(() -> PhotographFile.readScene(cut))
                .isInstanceOf(FileException.class)
                .hasMessageStartingWith(cut + ": cannot be read: ");
    }

    @ParameterizedTest
    @EnumSource
    void cutPicturesAreToldFromWholeOnes(PictureFormat format) throws IOException {
        for (int width : new int[] {1, 3, 40}) {
            Path whole = folder.resolve("whole" + format.endings().get(0));
            PhotographFile.write(whole, Samples.random(width, 50, 1), format, ToneCurve.LINEAR, Samples.INFO, true);
            PhotographFile.requireWhole(whole);
        }
        byte[] photograph = photograph(format);
        Path cut = file(Arrays.copyOf(photograph, photograph.length - 400));
        assertThat(PhotographFile.readScene(cut)).contains(Samples.SCENE);
        assertThatThrownBy(() -> PhotographFile.requireWhole(cut))
                .isInstanceOf(FileException.class)
                .hasMessageStartingWith(cut + ": the picture is damaged: ")
                .hasMessageMatching(".*(the file ends too early or contradicts itself|, but the file ends before)");
    }

    /** What the libraries say of it is "incorrect header check", or "Bad color type/bit depth combination!". */
    @ParameterizedTest
    @CsvSource({"IDAT, 5", "IHDR, 12"})
    void aChangedPictureIsDamagedInOurWords(String chunk, int place) throws IOException {
        byte[] png = photograph(PictureFormat.PNG);
        png[new String(png, ISO_8859_1).indexOf(chunk) + place] ^= 1;
        Path file = file(png);
        assertThatThrownBy(() -> PhotographFile.requireWhole(file))
                .hasMessageMatching(
                        ".*: the picture is damaged: the file is damaged in the part that begins at byte \\d+;"
                                + " another copy of it may be intact");
    }

    @Test
    void aChangedSceneIsNotBelieved() throws IOException {
        byte[] whole = photograph(PictureFormat.PNG);
        // before its keyword a text has four bytes of length and four of type
        int text = new String(whole, ISO_8859_1).indexOf("tompkins.scene") - 8;
        for (int place : new int[] {text, text + 48}) {
            byte[] png = whole.clone();
            png[place] ^= Byte.MIN_VALUE;
            Path file = file(png);
            assertThatThrownBy(() -> PhotographFile.readScene(file))
                    .isInstanceOf(FileException.class)
                    .hasMessage(file + ": cannot be read: the file is damaged in the part that begins at byte " + text
                            + "; another copy of it may be intact");
        }
    }

    @Test
    void aSceneThatSwellsWithoutEndIsRefused() throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(packed)) {
            byte[] blanks = new byte[1 << 20];
            for (int i = 0; i <= PhotographInfo.LONGEST_STORED_SCENE >> 20; i++) {
                deflater.write(blanks);
            }
        }
        Path file = file(pngWith(packed.toByteArray()));

        assertThatThrownBy(() -> PhotographFile.readScene(file))
                .isInstanceOf(FileException.class)
                .hasMessageContaining("too long");
    }

    private static byte[] pngWith(byte[] packed) throws IOException {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        text.write("tompkins.scene\0\1\0\0\0".getBytes(ISO_8859_1));
        text.write(packed);
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        png.writeBytes(PngChunk.SIGNATURE);
        new PngChunk("iTXt", text.toByteArray()).write(png);
        return png.toByteArray();
    }

    @Test
    void aPresetDictionaryIsNotAnEmptyScene() throws IOException {
        Deflater deflater = new Deflater();
        deflater.setDictionary("{\"camera\"".getBytes(ISO_8859_1));
        deflater.setInput("{\"camera\": {}}".getBytes(ISO_8859_1));
        deflater.finish();
        byte[] packed = new byte[100];
        Path file = file(pngWith(Arrays.copyOf(packed, deflater.deflate(packed))));
        assertThatThrownBy(() -> PhotographFile.readScene(file))
                .hasMessage(file + ": cannot be read: the scene in it is packed with a preset dictionary,"
                        + " which PNG does not allow");
    }

    @Test
    void aSceneThatIsNoTextIsRefused() throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(packed)) {
            deflater.write(new byte[] {'{', (byte) 0xc3, '}'});
        }
        Path file = file(pngWith(packed.toByteArray()));
        assertThatThrownBy(() -> PhotographFile.readScene(file))
                .hasMessage(file + ": cannot be read: the scene in it is not text in the encoding UTF-8");
    }

    @Test
    void whatIsNoPhotographIsRefusedWithWhatIs() throws IOException {
        Path text = file("hello".getBytes(ISO_8859_1));
        assertThatThrownBy(() -> PhotographFile.readScene(text))
                .isInstanceOf(FileException.class)
                .hasMessage(text
                        + ": not a picture; a photograph that holds its scene is a PNG, TIFF or Radiance HDR picture");

        Path gif = file("GIF89a".getBytes(ISO_8859_1));
        assertThatThrownBy(() -> PhotographFile.readScene(gif)).hasMessageStartingWith(gif + ": a GIF picture; ");

        Path lost = folder.resolve("lost.png");
        assertThatThrownBy(() -> PhotographFile.readScene(lost))
                .isInstanceOf(FileException.class)
                .hasMessage(lost + ": cannot be read: there is no such file or folder");
        assertThatThrownBy(() -> PhotographFile.readScene(folder)).isInstanceOf(FileException.class);
    }
}
