package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.file.FileException;

class BmpReaderTest {

    private static final int PLAIN = 0;
    private static final int MASKS = 3;

    /** A file with a header of a length, then what follows it (masks, palette), then its pixels. */
    private static byte[] bmp(
            int header, int width, int height, int bits, int compression, byte[] following, byte[] pixels) {
        int at = 14 + header + following.length;
        ByteBuffer file = ByteBuffer.allocate(at + pixels.length).order(ByteOrder.LITTLE_ENDIAN);
        file.put((byte) 'B')
                .put((byte) 'M')
                .putInt(file.capacity())
                .putInt(0)
                .putInt(at)
                .putInt(header);
        if (header == 12) {
            file.putShort((short) width)
                    .putShort((short) height)
                    .putShort((short) 1)
                    .putShort((short) bits);
        } else {
            file.putInt(width).putInt(height).putShort((short) 1).putShort((short) bits);
            file.putInt(compression).putInt(pixels.length);
        }
        file.position(14 + header);
        return file.put(following).put(pixels).array();
    }

    private static byte[] bytes(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        return bytes;
    }

    private static byte[] ints(long... values) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (long value : values) {
            bytes.putInt((int) value);
        }
        return bytes.array();
    }

    private static void assertPixels(byte[] file, double... rgba) throws IOException {
        float[] expected = new float[rgba.length];
        for (int i = 0; i < rgba.length; i++) {
            expected[i] = (float) rgba[i];
        }
        assertThat(BmpReader.read(file, "p.bmp").rgba()).containsExactly(expected, within(1e-6f));
    }

    /** Pixels of 16 and 32 bits with all masks, in headers of all lengths. */
    @ParameterizedTest
    @CsvSource({
        "16, 7c00, 3e0, 1f, 0, 7c1f, 1, 0, 1, 1",
        "16, f800, 7e0, 1f, 0, 07e1, 0, 1, 0.0322581, 1",
        "16, f00, f0, f, 0, 5f30, 1, 0.2, 0, 1",
        "16, 1, 2, 4, 0, 0005, 1, 0, 1, 1",
        "32, ff0000, ff00, ff, ff000000, 33ff0066, 1, 0, 0.4, 0.2",
        "32, ff, ff00, ff0000, 0, 33ff0066, 0.4, 0, 1, 1",
        "32, 3ff00000, ffc00, 3ff, 0, 7ff003ff, 1, 0, 1, 1"
    })
    void aChannelHasTheBitsOfItsMask(
            int bits,
            String red,
            String green,
            String blue,
            String opacity,
            String pixel,
            double r,
            double g,
            double b,
            double a)
            throws IOException {
        long[] masks = new long[4];
        for (int i = 0; i < 4; i++) {
            masks[i] = Long.parseLong(new String[] {red, green, blue, opacity}[i], 16);
        }
        byte[] pixels = ints(Long.parseLong(pixel, 16));
        byte[] three = Arrays.copyOf(ints(masks), 12);
        assertPixels(bmp(40, 1, 1, bits, MASKS, three, pixels), r, g, b, 1);
        for (int header : new int[] {108, 124}) {
            byte[] file = bmp(header, 1, 1, bits, MASKS, new byte[0], pixels);
            System.arraycopy(ints(masks), 0, file, 54, 16);
            assertPixels(file, r, g, b, a);
        }
    }

    @Test
    void withoutMasksTheUsualOnesHold() throws IOException {
        assertPixels(bmp(40, 1, 1, 16, PLAIN, new byte[0], ints(0x7c1f)), 1, 0, 1, 1);
        assertPixels(bmp(40, 1, 1, 32, PLAIN, new byte[0], ints(0x00ff0033)), 1, 0, 0.2, 1);
        assertPixels(bmp(124, 1, 1, 32, PLAIN, new byte[0], ints(0x00ff0033)), 1, 0, 0.2, 1);
        assertPixels(bmp(40, 1, 1, 24, PLAIN, new byte[0], bytes(51, 0, 255, 0)), 1, 0, 0.2, 1);
    }

    /** Rows go up, unless the height is negative, and are filled up to four bytes. */
    @ParameterizedTest
    @ValueSource(ints = {16, 24, 32})
    void rowsMayGoUpOrDown(int bits) throws IOException {
        byte[] pixels = switch (bits) {
            case 16 -> bytes(0x1f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x7c, 0, 0);
            case 24 -> bytes(255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0);
            default -> ints(0xff, 0, 0, 0, 0, 0xff0000);
        };
        double[] blue = {0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        double[] red = {0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1};
        double[] down = Arrays.copyOf(blue, 24);
        System.arraycopy(red, 0, down, 12, 12);
        double[] up = Arrays.copyOf(red, 24);
        System.arraycopy(blue, 0, up, 12, 12);
        assertPixels(bmp(40, 3, -2, bits, PLAIN, new byte[0], pixels), down);
        assertPixels(bmp(40, 3, 2, bits, PLAIN, new byte[0], pixels), up);
    }

    @ParameterizedTest
    @CsvSource({"-2, 2", "2, 0", "100000, 100000", "2, -2147483648"})
    void theSizeIsCheckedForAllBits(int width, int height) {
        for (int bits : new int[] {16, 24, 32}) {
            byte[] file = bmp(40, width, height, bits, PLAIN, new byte[8], new byte[16]);
            assertThatThrownBy(() -> PictureFile.read(file, "p.bmp"))
                    .hasMessage("p.bmp: claims to have " + width + " x " + Math.abs((long) height)
                            + " pixels; a picture may have from 1 to 64000000");
        }
    }

    /** A profile that is damaged, in the newest header, with colours that are not of a palette and that are. */
    @Test
    void aProfileChangesNothing() throws IOException {
        byte[] file = bmp(124, 1, 1, 24, PLAIN, new byte[0], bytes(51, 0, 255, 0));
        ByteBuffer.wrap(file)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(70, 0x4d424544)
                .putInt(126, 138)
                .putInt(130, 4);
        assertPixels(file, 1, 0, 0.2, 1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "12|24|0|has a header of 12 bytes; a BMP picture must have one of 40, 108 or 124",
                "64|24|0|has a header of 64 bytes; a BMP picture must have one of 40, 108 or 124",
                "40|8|0|has 8 bits a pixel; a BMP picture must have 16, 24 or 32",
                "40|64|0|has 64 bits a pixel; a BMP picture must have 16, 24 or 32",
                "40|24|11|its compression is number 11; a BMP picture must have none",
                "40|24|3|its compression is number 3; a BMP picture must have none",
                "40|32|6|its compression is number 6; a BMP picture must have none"
            })
    void whatIsNotReadIsNamed(int header, int bits, int compression, String reason) {
        byte[] file = bmp(header, 1, 1, bits, compression, new byte[0], new byte[64]);
        assertThatThrownBy(() -> PictureFile.read(file, "p.bmp"))
                .isInstanceOf(FileException.class)
                .hasMessage("p.bmp: " + reason + "; convert it, for example with ImageMagick or GIMP");
    }

    @ParameterizedTest
    @CsvSource({"f00f, f0, f00, f00f", "ff00, ff, 0, 0"})
    void masksThatTheLibraryMisreadsAreNamed(String red, String green, String blue, String wrong) {
        byte[] masks = ints(Long.parseLong(red, 16), Long.parseLong(green, 16), Long.parseLong(blue, 16));
        byte[] file = bmp(40, 1, 1, 16, MASKS, masks, new byte[4]);
        assertThatThrownBy(() -> PictureFile.read(file, "p.bmp"))
                .hasMessage(
                        "p.bmp: the mask of a channel is " + wrong
                                + "; a BMP picture must have bits for each, side by side; convert it, for example with ImageMagick or GIMP");
    }

    @Test
    void opacityInSixteenBitsIsNamed() {
        byte[] file = bmp(108, 1, 1, 16, MASKS, new byte[0], new byte[4]);
        System.arraycopy(ints(0xf00, 0xf0, 0xf, 0xf000), 0, file, 54, 16);
        assertThatThrownBy(() -> PictureFile.read(file, "p.bmp"))
                .hasMessage(
                        "p.bmp: has opacity in 16 bits; a BMP picture must have 32 bits for that; convert it, for example with ImageMagick or GIMP");
    }
}
