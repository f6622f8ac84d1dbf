package tompkins.image;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.file.FileException;

class JpegReaderTest {

    private static final int COLOUR = 0x4080c0;
    private static final int START_OF_FRAME = 0xc0;

    /** As the JDK writes it: JFIF, tables, a baseline frame of YCbCr, with the blue half of the colours subsampled. */
    private static byte[] jpeg(int width, int height) throws IOException {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < width * height; i++) {
            image.setRGB(i % width, i / width, i % width < 16 && i / width < 16 ? 0xffffff : COLOUR);
        }
        return Samples.encoded("jpeg", image);
    }

    private static byte[] segment(int marker, byte[]... parts) {
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            data.writeBytes(part);
        }
        ByteArrayOutputStream segment = new ByteArrayOutputStream();
        segment.write(0xff);
        segment.write(marker);
        segment.write(data.size() + 2 >> 8);
        segment.write(data.size() + 2);
        segment.writeBytes(data.toByteArray());
        return segment.toByteArray();
    }

    /** With segments after the start; JFIF, which the JDK puts there, stays behind them or goes. */
    private static byte[] with(byte[] jpeg, boolean jfif, byte[]... segments) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(jpeg, 0, 2);
        for (byte[] segment : segments) {
            out.writeBytes(segment);
        }
        int from = jfif ? 2 : 4 + ((jpeg[4] & 0xff) << 8 | jpeg[5] & 0xff);
        out.write(jpeg, from, jpeg.length - from);
        return out.toByteArray();
    }

    private static byte[] text(String text) {
        return text.getBytes(ISO_8859_1);
    }

    private static byte[] profile(int space) {
        return segment(
                0xe2,
                text("ICC_PROFILE\0"),
                new byte[] {1, 1},
                ICC_Profile.getInstance(space).getData());
    }

    private static void assertColour(byte[] jpeg) throws IOException {
        Pixels pixels = JpegReader.read(jpeg, "p.jpg");
        int last = pixels.rgba().length - 4;
        assertThat(Arrays.copyOfRange(pixels.rgba(), last, last + 4))
                .containsExactly(new float[] {64 / 255f, 128 / 255f, 192 / 255f, 1}, within(0.012f));
    }

    private static int frame(byte[] jpeg) {
        for (int at = 2; ; at += 2 + ((jpeg[at + 2] & 0xff) << 8 | jpeg[at + 3] & 0xff)) {
            if ((jpeg[at + 1] & 0xff) == START_OF_FRAME) {
                return at;
            }
        }
    }

    /** Numbers are the same with every profile, also with one that is damaged. */
    @Test
    void aProfileChangesNothing() throws IOException {
        byte[] plain = jpeg(48, 32);
        float[] numbers = JpegReader.read(plain, "p.jpg").rgba();
        assertColour(plain);
        byte[] damaged = segment(0xe2, text("ICC_PROFILE\0\1\1no profile"));
        for (byte[] profile : new byte[][] {
            profile(ColorSpace.CS_LINEAR_RGB), profile(ColorSpace.CS_sRGB), profile(ColorSpace.CS_GRAY), damaged
        }) {
            assertThat(JpegReader.read(with(plain, true, profile), "p.jpg").rgba())
                    .isEqualTo(numbers);
            assertThat(JpegReader.read(with(plain, false, profile), "p.jpg").rgba())
                    .isEqualTo(numbers);
        }
    }

    /** JFIF and Exif are YCbCr, Adobe's marker says what it is, and without any the names of the components tell. */
    @Test
    void theColoursAreThoseOfTheMarkers() throws IOException {
        byte[] plain = jpeg(48, 32);
        assertColour(with(plain, false));
        assertColour(with(plain, false, segment(0xe1, text("Exif\0\0"), PngReaderTest.exif(1))));
        assertColour(with(plain, false, adobe(1)));
        assertColour(with(plain, true, adobe(1)));
        // The same samples taken for red, green and blue are the YCbCr of the colour (JFIF 1.02).
        byte[] named = with(plain, false);
        int components = frame(named) + 10;
        int scan = new String(named, ISO_8859_1).indexOf("\u00ff\u00da") + 5;
        for (int i = 0; i < 3; i++) {
            named[components + 3 * i] = (byte) "RGB".charAt(i);
            named[scan + 2 * i] = (byte) "RGB".charAt(i);
        }
        for (byte[] rgb : new byte[][] {named, with(plain, false, adobe(0))}) {
            float[] rgba = JpegReader.read(rgb, "p.jpg").rgba();
            double y = 0.299 * 64 + 0.587 * 128 + 0.114 * 192;
            assertThat(Arrays.copyOfRange(rgba, rgba.length - 4, rgba.length))
                    .containsExactly(
                            new float[] {
                                (float) y / 255,
                                (float) (128 + (192 - y) / 1.772) / 255,
                                (float) (128 + (64 - y) / 1.402) / 255,
                                1
                            },
                            within(0.012f));
        }
    }

    private static byte[] adobe(int transform) {
        return segment(0xee, text("Adobe"), new byte[] {0, 100, 0, 0, 0, 0, (byte) transform});
    }

    /** The white corner, which is stored at the upper left, where a viewer shows it. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0", "3, 1, 1", "6, 1, 0", "77, 0, 0"})
    void exifTurnsThePicture(int orientation, int right, int bottom) throws IOException {
        byte[] exif = segment(0xe1, text("Exif\0\0"), PngReaderTest.exif(orientation));
        byte[] other = segment(0xe1, text("http://ns.adobe.com/xap/1.0/\0"));
        for (byte[] file : new byte[][] {with(jpeg(48, 32), true, other, exif), with(jpeg(48, 32), false, exif)}) {
            Pixels pixels = JpegReader.read(file, "p.jpg");
            boolean upright = orientation >= 5 && orientation <= 8;
            assertThat(pixels.width()).isEqualTo(upright ? 32 : 48);
            assertThat(pixels.height()).isEqualTo(upright ? 48 : 32);
            int x = right * (pixels.width() - 1);
            int y = bottom * (pixels.height() - 1);
            for (int corner = 0; corner < 4; corner++) {
                int cornerX = corner % 2 * (pixels.width() - 1);
                int cornerY = corner / 2 * (pixels.height() - 1);
                float red = pixels.rgba()[4 * (cornerY * pixels.width() + cornerX)];
                assertThat(red > 0.5).isEqualTo(cornerX == x && cornerY == y);
            }
        }
    }

    @Test
    void greyIsTakenAsItIs() throws IOException {
        BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < 64; i++) {
            image.getRaster().setSample(i % 8, i / 8, 0, 51);
        }
        byte[] grey = Samples.encoded("jpeg", image);
        for (byte[] file : new byte[][] {grey, with(grey, false), with(grey, true, profile(ColorSpace.CS_GRAY))}) {
            assertThat(JpegReader.read(file, "p.jpg").rgba()).startsWith(0.2f, 0.2f, 0.2f, 1);
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "195| its coding is lossless; a JPEG picture must be baseline or progressive; convert it, for example with ImageMagick or GIMP",
                "197| its coding is hierarchical; a JPEG picture must be baseline or progressive; convert it, for example with ImageMagick or GIMP",
                "203| its coding is arithmetic; a JPEG picture must be baseline or progressive; convert it, for example with ImageMagick or GIMP",
                "247| its coding is JPEG-LS; a JPEG picture must be baseline or progressive; convert it, for example with ImageMagick or GIMP"
            })
    void aCodingThatIsNotReadIsNamed(int marker, String reason) throws IOException {
        byte[] file = jpeg(16, 16);
        file[frame(file) + 1] = (byte) marker;
        assertRefused(file, reason);
    }

    @Test
    void bitsThatAreNotReadAreNamed() throws IOException {
        byte[] file = jpeg(16, 16);
        file[frame(file) + 4] = 12;
        assertRefused(
                file,
                "has 12 bits a sample; a JPEG picture must have 8; convert it, for example with ImageMagick or GIMP");
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 4, 5})
    void coloursThatAreNotReadAreNamed(int count) throws IOException {
        byte[] file = jpeg(16, 16);
        file[frame(file) + 9] = (byte) count;
        assertRefused(
                file,
                "has " + count
                        + (count == 4 ? " colours, as for printing in cyan, magenta, yellow and black" : " colours")
                        + "; a JPEG picture must be grey or red, green and blue; convert it, for example with ImageMagick or GIMP");
    }

    private static void assertRefused(byte[] file, String reason) {
        assertThatThrownBy(() -> PictureFile.read(file, "p.jpg"))
                .isInstanceOf(FileException.class)
                .hasMessage("p.jpg: " + reason);
    }
}
