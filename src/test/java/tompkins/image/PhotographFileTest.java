package tompkins.image;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.zip.InflaterInputStream;
import javax.imageio.ImageReader;
import javax.imageio.plugins.tiff.BaselineTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.OnLinux;
import tompkins.RunningJava;
import tompkins.file.FileException;

class PhotographFileTest {

    private final LinearImage image = Samples.random(37, 23, 4);

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void nameTheFile() {
        file = folder.resolve("photo.png");
    }

    private Path write(PictureFormat format, ToneCurve curve, PhotographInfo info) throws IOException {
        Path path = folder.resolve(format.name() + format.endings().get(0));
        PhotographFile.write(path, image, format, curve, info, true);
        return path;
    }

    @ParameterizedTest
    @EnumSource(names = {"PNG", "PNG16", "TIFF"})
    void aReaderOfTheJdkFindsTheLevels(PictureFormat format) throws IOException {
        int maximum = format == PictureFormat.PNG ? 255 : 65535;
        for (ToneCurve curve : ToneCurve.values()) {
            byte[] bytes = Files.readAllBytes(write(format, curve, Samples.INFO));
            int[] levels = raster(format, bytes).getPixels(0, 0, 37, 23, (int[]) null);

            assertThat(levels).hasSize(3 * 37 * 23);
            for (int i = 0; i < levels.length; i++) {
                assertThat(levels[i]).isEqualTo(curve.quantise(image.rgb()[i], maximum));
            }
        }
    }

    @Test
    void aFloatingPointTiffHoldsTheLightItself() throws IOException {
        image.rgb()[5] = 1e30f;
        image.rgb()[6] = -3e-40f;
        byte[] bytes = Files.readAllBytes(write(PictureFormat.TIFF_FLOAT, ToneCurve.SRGB, Samples.INFO));

        assertThat(raster(PictureFormat.TIFF_FLOAT, bytes).getPixels(0, 0, 37, 23, (float[]) null))
                .containsExactly(image.rgb());
    }

    private static java.awt.image.Raster raster(PictureFormat format, byte[] bytes) throws IOException {
        ImageReader reader = Samples.jdkReader(format.name().startsWith("PNG") ? "png" : "tiff", bytes);
        return reader.read(0).getRaster();
    }

    /** The chunk before the pixels that viewers of stereo pairs look for: its length, type, mode and check sum. */
    @ParameterizedTest
    @CsvSource({"32, true, true", "32, false, false", "36, true, false"})
    void aStereoPairSaysSo(int width, boolean isPair, boolean says) throws IOException {
        PhotographInfo info = new PhotographInfo("Pair", "", "{}", Optional.empty(), isPair, "");
        PhotographFile.write(file, Samples.random(width, 2, 1), PictureFormat.PNG, ToneCurve.LINEAR, info, true);
        String bytes = Files.readString(file, ISO_8859_1);
        assertThat(bytes.indexOf("IDAT") > bytes.indexOf("\0\0\0\1sTER\1") && bytes.contains("\0\0\0\1sTER\1"))
                .isEqualTo(says);
    }

    @ParameterizedTest
    @EnumSource
    void theSceneComesBackLetterByLetter(PictureFormat format) throws IOException {
        assertThat(PhotographFile.readScene(write(format, ToneCurve.LINEAR, Samples.INFO)))
                .contains(Samples.SCENE);

        String longScene = Samples.longScene();
        assertThat(longScene.length()).isGreaterThan(1_000_000);
        Path path = write(format, ToneCurve.LINEAR, new PhotographInfo("", "", longScene));
        assertThat(PhotographFile.readScene(path).orElseThrow().equals(longScene))
                .isTrue();
    }

    @ParameterizedTest
    @EnumSource
    void aPhotographWithoutASceneSaysSo(PictureFormat format) throws IOException {
        assertThat(PhotographFile.readScene(write(format, ToneCurve.LINEAR, PhotographInfo.NONE)))
                .isEmpty();
    }

    @ParameterizedTest
    @EnumSource
    void theSameArgumentsGiveTheSameBytes(PictureFormat format) throws IOException {
        byte[] first = Files.readAllBytes(write(format, ToneCurve.LINEAR, Samples.INFO));
        byte[] second = Files.readAllBytes(write(format, ToneCurve.LINEAR, Samples.INFO));

        assertThat(second).isEqualTo(first);
        assertThat(new String(first, ISO_8859_1)).doesNotContain("tIME").doesNotContain("20" + "26:");
    }

    @Test
    void pngKeepsTheTextsWhereOtherProgramsLook() throws IOException {
        byte[] png = Files.readAllBytes(write(PictureFormat.PNG, ToneCurve.LINEAR, Samples.INFO));

        assertThat(Samples.chunks(png, "tEXt"))
                .extracting(text -> new String(text, ISO_8859_1))
                .contains("Software\0Tompkins 1.0");
        List<byte[]> texts = Samples.chunks(png, "iTXt");
        assertThat(texts)
                .extracting(text -> new String(text, UTF_8))
                .contains("Title\0\0\0\0Title\0Würfel bei β = 0.96");
        byte[] scene = texts.stream()
                .filter(text -> new String(text, ISO_8859_1).startsWith("tompkins.scene\0\1\0\0\0"))
                .findFirst()
                .orElseThrow();
        ByteArrayInputStream compressed = new ByteArrayInputStream(scene, 19, scene.length - 19);
        assertThat(new InflaterInputStream(compressed).readAllBytes()).isEqualTo(Samples.SCENE.getBytes(UTF_8));
    }

    @Test
    void tiffKeepsTheSceneAsAsciiInTheDescription() throws IOException {
        byte[] tiff = Files.readAllBytes(write(PictureFormat.TIFF, ToneCurve.LINEAR, Samples.INFO));

        TIFFDirectory tags =
                TIFFDirectory.createFromMetadata(Samples.jdkReader("tiff", tiff).getImageMetadata(0));

        assertThat(tags.getTIFFField(BaselineTIFFTagSet.TAG_COMPRESSION).getAsInt(0))
                .as("8 is Deflate, which all readers know")
                .isEqualTo(8);
        assertThat(tags.getTIFFField(BaselineTIFFTagSet.TAG_IMAGE_DESCRIPTION).getAsString(0))
                .startsWith("{\n\t\"title\": \"\\u03b2\\u03b3 at \\u00bd c, \\\\u03b2 \\ud835\\udefd")
                .matches("\\p{ASCII}*");
        assertThat(tags.getTIFFField(BaselineTIFFTagSet.TAG_SOFTWARE).getAsString(0))
                .isEqualTo("Tompkins 1.0");
        assertThat(tags.getTIFFField(BaselineTIFFTagSet.TAG_DOCUMENT_NAME).getAsString(0))
                .isEqualTo("W\\u00fcrfel bei \\u03b2 = 0.96");
    }

    @Test
    void aDescriptionThatIsNoSceneIsNotTakenForOne() throws IOException {
        Path tiff = write(PictureFormat.TIFF, ToneCurve.LINEAR, new PhotographInfo("", "", "{\"a\": \"a cat\"}"));
        byte[] bytes = Files.readAllBytes(tiff);
        int at = new String(bytes, ISO_8859_1).indexOf("{\"a\": \"a cat\"}");
        bytes[at] = 'A';
        Files.write(tiff, bytes);

        assertThat(PhotographFile.readScene(tiff)).isEmpty();
    }

    @Test
    @OnLinux
    void aNewFileIsAsOpenToOthersAsAnyOther() throws IOException {
        Path ordinary = Files.createFile(folder.resolve("ordinary"));

        PhotographFile.write(file, image, PictureFormat.PNG, ToneCurve.LINEAR, Samples.INFO, true);

        assertThat(Files.getAttribute(file, "unix:mode")).isEqualTo(Files.getAttribute(ordinary, "unix:mode"));
    }

    @Test
    @OnLinux
    void aLinkStaysAndWhatItPointsToIsReplaced() throws IOException {
        Path real = Files.writeString(folder.resolve("real.png"), "old");
        Files.createSymbolicLink(file, real);

        PhotographFile.write(file, image, PictureFormat.PNG, ToneCurve.LINEAR, Samples.INFO, true);

        assertThat(file).isSymbolicLink();
        assertThat(PhotographFile.readScene(real)).contains(Samples.SCENE);
    }

    private void assertRefused(Path target, String reason) {
        assertThatThrownBy(() ->
                        PhotographFile.write(target, image, PictureFormat.PNG, ToneCurve.LINEAR, Samples.INFO, true))
                .isInstanceOf(FileException.class)
                .hasMessage(target + ": cannot be written: " + reason);
    }

    @Test
    @OnLinux
    void aLinkToNothingIsRefused() throws IOException {
        Files.createSymbolicLink(file, file);
        assertRefused(file, "it is a link to nothing that exists");
        assertThat(file).isSymbolicLink();
    }

    @Test
    void aFolderIsNotOverwritten() throws IOException {
        Files.createDirectory(file);

        assertRefused(file, "it is a folder; name a file in it");
        assertThat(Samples.names(folder)).containsExactly("photo.png");
    }

    @Test
    void aMissingFolderIsNamed() {
        Path lost = folder.resolve("lost").resolve("photo.png");

        assertRefused(lost, "there is no folder " + folder.resolve("lost"));
    }

    @Test
    @OnLinux
    void aFolderWithoutPermissionIsNamed() throws IOException {
        Path closed = folder.resolve("closed");
        Files.createDirectory(closed);
        closed.toFile().setWritable(false);
        // The administrator may write everywhere but into the kernel's own folder.
        boolean administrator = Files.isWritable(closed);
        Path target = (administrator ? Path.of("/sys") : closed).resolve("photo.png");

        assertRefused(target, "there is no permission");
    }

    /** A real failure in the middle: the shell lets no file of the process grow beyond 2 blocks of 512 bytes. */
    @ParameterizedTest
    @OnLinux
    @EnumSource
    void whenThereIsNoSpaceTheOldFileStays(PictureFormat format) throws IOException, InterruptedException {
        Path target = folder.resolve("photo" + format.endings().get(0));
        Files.writeString(target, "old");

        Process process = new ProcessBuilder(
                        "sh",
                        "-c",
                        "ulimit -f 2; exec \"$0\" -Xshare:auto -XX:-UsePerfData -cp \"$1\" \"$2\" \"$3\" \"$4\"",
                        RunningJava.PROGRAM,
                        RunningJava.CLASS_PATH,
                        SaveInLittleSpace.class.getName(),
                        target.toString(),
                        format.name())
                .redirectErrorStream(true)
                .start();
        String said = new String(process.getInputStream().readAllBytes(), UTF_8);

        assertThat(process.waitFor()).as(said).isEqualTo(3);
        assertThat(said).isEqualTo(target + ": cannot be written: File too large");
        assertThat(target).hasContent("old");
        assertThat(Samples.names(folder)).containsExactly(target.getFileName().toString());
    }

    /** Saves a photograph of 100 x 100 pixels; prints the message and ends with 3 if that fails as it should. */
    static final class SaveInLittleSpace {

        public static void main(String[] arguments) {
            try {
                PhotographFile.write(
                        Path.of(arguments[0]),
                        Samples.random(100, 100, 1),
                        PictureFormat.valueOf(arguments[1]),
                        ToneCurve.LINEAR,
                        Samples.INFO,
                        true);
            } catch (FileException e) {
                System.out.print(e.getMessage());
                System.exit(3);
            }
        }
    }
}
