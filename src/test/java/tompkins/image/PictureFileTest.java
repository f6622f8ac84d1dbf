package tompkins.image;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeout;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.OnLinux;
import tompkins.TestRun;
import tompkins.file.FileException;
import tompkins.ray.Colour;
import tompkins.ray.PixelPicture;

class PictureFileTest {

    private static final long SEED = 20261103;

    @TempDir
    private Path folder;

    private byte[] photograph(LinearImage image, PictureFormat format) throws IOException {
        Path file = folder.resolve(format.name() + format.endings().get(0));
        PhotographFile.write(file, image, format, ToneCurve.LINEAR, Samples.INFO, true);
        return Files.readAllBytes(file);
    }

    private static Colour pixel(PixelPicture picture, int x, int y) {
        return picture.colour((x + 0.5) / picture.width(), 1 - (y + 0.5) / picture.height());
    }

    private static void assertPixel(PixelPicture picture, int x, int y, double red, double green, double blue) {
        Colour colour = pixel(picture, x, y);
        assertThat(new double[] {colour.red(), colour.green(), colour.blue()})
                .as("pixel %d, %d", x, y)
                .containsExactly(new double[] {red, green, blue}, within(1e-7));
    }

    @ParameterizedTest
    @CsvSource({"PNG, 255", "PNG16, 65535", "TIFF, 65535"})
    void levelsAreDividedByTheLargest(PictureFormat format, int maximum) throws IOException {
        LinearImage image = Samples.random(19, 11, 8);
        byte[] file = photograph(image, format);

        PixelPicture picture = PictureFile.read(file, "wall");

        assertThat(picture.name()).isEqualTo("wall");
        assertThat(picture.width()).isEqualTo(19);
        assertThat(picture.height()).isEqualTo(11);
        assertThat(picture.file()).isEqualTo(file);
        for (int y = 0; y < 11; y++) {
            for (int x = 0; x < 19; x++) {
                double[] stored = new double[3];
                for (int channel = 0; channel < 3; channel++) {
                    double light = Math.min(1, Math.max(0, image.value(x, y, channel)));
                    stored[channel] = Math.floor(maximum * light) / maximum;
                }
                assertPixel(picture, x, y, stored[0], stored[1], stored[2]);
            }
        }
    }

    @Test
    @OnLinux
    void aFileIsReadByItsContentAndNamedInMessages() throws IOException {
        byte[] png = photograph(Samples.random(9, 9, 2), PictureFormat.PNG);
        Path file = Files.write(folder.resolve("wrong.jpg"), png);
        assertThat(PictureFile.read(file).name()).isEqualTo(file.getFileName().toString());

        Path lost = folder.resolve("lost.png");
        assertThatThrownBy(() -> PictureFile.read(lost))
                .isInstanceOf(FileException.class)
                .hasMessage(lost + ": cannot be read: there is no such file or folder");
        assertThatThrownBy(() -> PictureFile.read(folder))
                .isInstanceOf(FileException.class)
                .hasMessage(folder + ": not a file");
        Path endless = Path.of("/dev/zero");
        assertThatThrownBy(() -> PictureFile.read(endless)).hasMessage("/dev/zero: not a file");
    }

    @Test
    void whatIsNoPictureIsRefusedWithWhatIs() {
        assertThatThrownBy(() -> PictureFile.read(new byte[0], "empty.png"))
                .isInstanceOf(FileException.class)
                .hasMessage("empty.png: the file is empty; allowed are PNG, JPEG, TIFF and Radiance HDR");
        assertThatThrownBy(() -> PictureFile.read("hello".getBytes(ISO_8859_1), "letter.png"))
                .isInstanceOf(FileException.class)
                .hasMessage("letter.png: not a picture that can be read;"
                        + " allowed are PNG, JPEG, TIFF and Radiance HDR");
    }

    /** Headers that claim 100000 x 100000 pixels, or as many as the format can claim. */
    @Test
    void aClaimIsCheckedBeforeAnythingIsMade() throws IOException {
        byte[] png = photograph(Samples.random(9, 9, 2), PictureFormat.PNG);
        ByteBuffer.wrap(png).putInt(16, 100_000).putInt(20, 100_000);
        assertBomb(png, "100000 x 100000");

        ByteArrayOutputStream hdr = new ByteArrayOutputStream();
        hdr.writeBytes("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n".getBytes(ISO_8859_1));
        assertBomb(hdr.toByteArray(), "100000 x 100000");

        BufferedImage small = new BufferedImage(9, 9, BufferedImage.TYPE_INT_RGB);
        byte[] jpeg = Samples.encoded("jpeg", small);
        int frame = new String(jpeg, ISO_8859_1).indexOf("\u00ff\u00c0");
        ByteBuffer.wrap(jpeg).putShort(frame + 5, (short) 65000).putShort(frame + 7, (short) 65535);
        assertBomb(jpeg, "65535 x 65000");
        ByteBuffer.wrap(jpeg).putShort(frame + 5, (short) 0);
        assertBomb(jpeg, "65535 x 0");

        byte[] tiff = photograph(Samples.random(9, 9, 2), PictureFormat.TIFF);
        claimInTiff(tiff, 256, 100_000);
        claimInTiff(tiff, 257, 100_000);
        assertBomb(tiff, "100000 x 100000");
    }

    /** The first directory of a TIFF file: a number of entries of tag, type, count, value. */
    private static void claimInTiff(byte[] tiff, int tag, int value) {
        ByteBuffer file = ByteBuffer.wrap(tiff);
        if (tiff[0] == 'I') {
            file.order(ByteOrder.LITTLE_ENDIAN);
        }
        int directory = file.getInt(4);
        for (int entry = 0; entry < file.getShort(directory); entry++) {
            int at = directory + 2 + 12 * entry;
            if (file.getShort(at) == tag) {
                file.putShort(at + 2, (short) 4).putInt(at + 8, value);
            }
        }
    }

    private static void assertBomb(byte[] file, String claim) {
        assertTimeout(
                Duration.ofMinutes(5),
                () -> assertThatThrownBy(() -> PictureFile.read(file, "bomb"))
                        .isInstanceOf(FileException.class)
                        .hasMessage(
                                "bomb: claims to have " + claim + " pixels; a picture may have from 1 to 64000000"));
    }

    /** The JDK's readers lose rows and pixels of such pictures, or guess, and say nothing. */
    @ParameterizedTest
    @ValueSource(strings = {"GIF", "BMP"})
    void whatTheReadersGuessIsRefusedWithAWayOut(String format) throws IOException {
        byte[] file = Samples.encoded(format, new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB));
        assertThatThrownBy(() -> PictureFile.read(file, "logo"))
                .isInstanceOf(FileException.class)
                .hasMessage("logo: is a " + format + " picture; allowed are PNG, JPEG, TIFF and Radiance HDR;"
                        + " convert it to PNG, for example with ImageMagick or GIMP");
    }

    @ParameterizedTest
    @EnumSource(
            mode = EnumSource.Mode.EXCLUDE,
            names = {"GIF", "BMP"})
    void aFileThatEndsTooEarlyIsRefused(PictureEncoding encoding) throws IOException {
        byte[] file = sample(encoding);
        // The last bytes of some formats say only that nothing follows.
        for (int length = 1; length < file.length - 25; length += 5) {
            byte[] start = Arrays.copyOf(file, length);
            assertThatThrownBy(() -> PictureFile.read(start, "half"))
                    .as("%d of %d bytes", length, file.length)
                    .isInstanceOf(FileException.class)
                    .hasMessageStartingWith("half: ");
        }
    }

    @ParameterizedTest
    @EnumSource(
            mode = EnumSource.Mode.EXCLUDE,
            names = {"GIF", "BMP"})
    void aDamagedFileGivesAPictureOrOneMessage(PictureEncoding encoding) throws IOException {
        byte[] file = sample(encoding);
        Random random = new Random(SEED);
        int refused = 0;
        int files = Integer.getInteger("tompkins.fuzz", TestRun.cases(25, 300));
        for (int i = 0; i < files; i++) {
            byte[] damaged = Samples.damaged(file, random);
            refused += assertTimeout(Duration.ofMinutes(5), () -> messages(damaged));
        }
        assertThat(messages(file)).as("the whole file").isZero();
        assertThat(refused).as("seed %d", SEED).isGreaterThanOrEqualTo(files / 6);
    }

    private static int messages(byte[] damaged) {
        try {
            PictureFile.read(damaged, "damaged");
            return 0;
        } catch (FileException e) {
            assertThat(e.getMessage())
                    .startsWith("damaged: ")
                    .doesNotContain("\n")
                    .doesNotContain("Exception");
            return 1;
        }
    }

    private byte[] sample(PictureEncoding encoding) throws IOException {
        LinearImage image = Samples.random(24, 20, 1);
        BufferedImage shown = BufferedImages.toBufferedImage(image, ToneCurve.LINEAR);
        return switch (encoding) {
            case PNG -> photograph(image, PictureFormat.PNG16);
            case TIFF -> photograph(image, PictureFormat.TIFF_FLOAT);
            case HDR -> photograph(image, PictureFormat.HDR);
            case JPEG, GIF, BMP -> Samples.encoded(encoding.name(), shown);
        };
    }
}
