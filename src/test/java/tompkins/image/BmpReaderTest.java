package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BmpReaderTest {

    private static final int PLAIN = 0;
    private static final int RUNS_OF_8 = 1;
    private static final int RUNS_OF_4 = 2;
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

    /** Pixels of 16 and 32 bits with all masks, in headers of all lengths; one mask of no bits is no channel. */
    @ParameterizedTest
    @CsvSource({
        "16, ff00, ff, 0, 0, 80ff, 0.5019608, 1, 0, 1",
        "16, 7c00, 3e0, 1f, 0, 7c1f, 1, 0, 1, 1",
        "16, f800, 7e0, 1f, 0, 07e1, 0, 1, 0.0322581, 1",
        "16, f00, f0, f, f000, 5f30, 1, 0.2, 0, 0.3333333",
        "16, 7c00, 3e0, 1f, 8000, 7fe0, 1, 1, 0, 0",
        "16, 0, 0, ffff, 0, 8000, 0, 0, 0.5000076, 1",
        "16, 1, 2, 4, 8, 0005, 1, 0, 1, 0",
        "32, ff0000, ff00, ff, ff000000, 33ff0066, 1, 0, 0.4, 0.2",
        "32, ff, ff00, ff0000, 0, 33ff0066, 0.4, 0, 1, 1",
        "32, 3ff00000, ffc00, 3ff, c0000000, 7ff003ff, 1, 0, 1, 0.3333333",
        "32, 0, ff00, ff, 0, ffffffff, 0, 1, 1, 1",
        "32, fffff000, fff, 0, 0, 80000800, 0.5000005, 0.5001221, 0, 1",
        "32, ffffffff, 0, 0, 0, 80000000, 0.5, 0, 0, 1"
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
        byte[] four = ints(masks);
        byte[] three = Arrays.copyOf(four, 12);
        assertPixels(bmp(40, 1, 1, bits, MASKS, three, pixels), r, g, b, 1);
        assertPixels(bmp(40, 1, 1, bits, 6, four, pixels), r, g, b, a);
        for (int header : new int[] {52, 56, 108, 124}) {
            byte[] file = bmp(header, 1, 1, bits, MASKS, new byte[0], pixels);
            System.arraycopy(four, 0, file, 54, header == 52 ? 12 : 16);
            assertPixels(file, r, g, b, header == 52 ? 1 : a);
        }
    }

    @Test
    void withoutMasksTheUsualOnesHold() throws IOException {
        assertPixels(bmp(40, 1, 1, 16, PLAIN, new byte[0], ints(0x7c1f)), 1, 0, 1, 1);
        assertPixels(bmp(40, 1, 1, 32, PLAIN, new byte[0], ints(0x00ff0033)), 1, 0, 0.2, 1);
        assertPixels(bmp(124, 1, 1, 32, PLAIN, new byte[0], ints(0x00ff0033)), 1, 0, 0.2, 1);
        assertPixels(bmp(40, 1, 1, 24, PLAIN, new byte[0], bytes(51, 0, 255, 0)), 1, 0, 0.2, 1);
        assertPixels(bmp(12, 1, 1, 24, PLAIN, new byte[0], bytes(51, 0, 255, 0)), 1, 0, 0.2, 1);
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
    @ValueSource(ints = {1, 4, 8})
    void aPaletteIsLookedUp(int bits) throws IOException {
        byte[] pixels = bits == 1 ? bytes(0x40, 0, 0, 0) : bits == 4 ? bytes(0x01, 0, 0, 0) : bytes(0, 1, 0, 0);
        byte[] palette = bytes(51, 0, 255, 0, 0, 102, 0, 0);
        assertPixels(bmp(40, 2, 1, bits, PLAIN, palette, pixels), 1, 0, 0.2, 1, 0, 0.4, 0, 1);
        assertPixels(bmp(40, 2, -1, bits, PLAIN, palette, pixels), 1, 0, 0.2, 1, 0, 0.4, 0, 1);
        assertPixels(bmp(124, 2, 1, bits, PLAIN, palette, pixels), 1, 0, 0.2, 1, 0, 0.4, 0, 1);
        byte[] three = bytes(51, 0, 255, 0, 102, 0);
        assertPixels(bmp(12, 2, 1, bits, PLAIN, three, pixels), 1, 0, 0.2, 1, 0, 0.4, 0, 1);
        byte[] greys = bytes(51, 51, 51, 0, 255, 255, 255, 0);
        assertPixels(bmp(40, 2, 1, bits, PLAIN, greys, pixels), 0.2, 0.2, 0.2, 1, 1, 1, 1, 1);
    }

    /** Runs, literals, the end of a row, a jump, and the end, all from the lowest row up. */
    @Test
    void runLengthsAreUnpacked() throws IOException {
        byte[] palette = bytes(0, 0, 0, 0, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 0);
        byte[] eight = bytes(2, 1, 0, 3, 2, 3, 1, 0, 0, 0, 0, 2, 2, 0, 1, 2, 0, 1);
        byte[] four = bytes(2, 0x11, 0, 3, 0x23, 0x10, 0, 0, 0, 2, 2, 0, 1, 0x20, 0, 1);
        int[] expected = {0, 0, 2, 0, 0, 1, 1, 2, 3, 1};
        double[] rgba = new double[40];
        for (int i = 0; i < 10; i++) {
            rgba[4 * i + 3] = 1;
            if (expected[i] > 0) {
                rgba[4 * i + expected[i] - 1] = 1;
            }
        }
        assertPixels(bmp(40, 5, 2, 8, RUNS_OF_8, palette, eight), rgba);
        assertPixels(bmp(40, 5, 2, 4, RUNS_OF_4, palette, four), rgba);
    }

    /** The end of a row or picture may be told or not; what lies beyond a row is passed over. */
    @ParameterizedTest
    @CsvSource({
        "8, '3 1 0 0 3 2 0 1', 111222",
        "8, '3 1 0 0 3 2', 111222",
        "8, '4 1 0 0 5 2 0 0 3 1 0 1', 111222",
        "8, '0 3 1 2 1 0 0 0 0 4 2 2 1 1 0 1', 121221",
        "8, '3 1 0 1', 111000",
        "8, '1 1 0 2 1 1 1 2 0 1', 100002",
        "8, '0 2 3 1 3 1 0 1', 000000",
        "4, '4 18 0 0 1 32 2 18 0 1', 121212",
        "4, '0 3 18 16 0 0 0 5 33 33 16 0 0 1', 121212"
    })
    void codesOfRunLengthsMayEndInManyWays(int bits, String codes, String expected) throws IOException {
        byte[] pixels = bytes(
                Arrays.stream(codes.split(" ")).mapToInt(Integer::parseInt).toArray());
        byte[] palette = bytes(0, 0, 0, 0, 0, 0, 255, 0, 0, 255, 0, 0);
        double[] rgba = new double[24];
        for (int i = 0; i < 6; i++) {
            int colour = expected.charAt((i + 3) % 6) - '0';
            rgba[4 * i + 3] = 1;
            if (colour > 0) {
                rgba[4 * i + colour - 1] = 1;
            }
        }
        assertPixels(bmp(40, 3, 2, bits, bits == 8 ? RUNS_OF_8 : RUNS_OF_4, palette, pixels), rgba);
    }

    /** Rows that are missing are not taken for rows of the first colour. */
    @ParameterizedTest
    @ValueSource(strings = {"3 1 0 0", "3 1 0 0 3", "3 1 0 0 2 2", "3 1", "0 3 1 2", "0 2 1"})
    void runLengthsThatEndTooEarlyAreRefused(String codes) {
        byte[] pixels = bytes(
                Arrays.stream(codes.split(" ")).mapToInt(Integer::parseInt).toArray());
        byte[] file = bmp(40, 3, 2, 8, RUNS_OF_8, new byte[12], pixels);
        assertThatThrownBy(() -> PictureFile.read(file, "p.bmp"))
                .hasMessage("p.bmp: BMP picture cannot be read: the file ends too early or contradicts itself");
    }

    /** The pixels may lie anywhere after the palette, which may have fewer colours than its bits can count. */
    @ParameterizedTest
    @CsvSource({"1, 1", "1, 2", "4, 3", "8, 3"})
    void thePlaceOfThePixelsSaysNothingOfThePalette(int bits, int colours) throws IOException {
        byte[] pixels = bits == 1 ? bytes(0, 0, 0, 0) : bits == 4 ? bytes(0x20, 0, 0, 0) : bytes(2, 0, 0, 0);
        byte[] palette = Arrays.copyOf(bytes(51, 0, 255, 0, 0, 102, 0, 0, 0, 0, 153, 0), 4 * colours);
        for (int gap : new int[] {0, 1, 10, 1100}) {
            byte[] file = bmp(40, 1, 1, bits, PLAIN, Arrays.copyOf(palette, palette.length + gap), pixels);
            ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).putInt(46, colours);
            assertPixels(file, bits == 1 ? 1 : 0.6, 0, bits == 1 ? 0.2 : 0, 1);
        }
    }

    @Test
    void aColourOutsideThePaletteIsNamed() {
        byte[] file = bmp(40, 1, 1, 8, PLAIN, new byte[12], bytes(3, 0, 0, 0));
        assertThatThrownBy(() -> PictureFile.read(file, "p.bmp"))
                .hasMessage("p.bmp: BMP picture cannot be read: a pixel's colour is not in the palette");
    }

    @Test
    void pixelsInsideTheHeaderAreNamed() {
        byte[] file = bmp(40, 1, 1, 24, PLAIN, new byte[0], bytes(3, 0, 0, 0));
        ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).putInt(10, 0);
        assertThatThrownBy(() -> PictureFile.read(file, "p.bmp"))
                .hasMessage("p.bmp: its pixels begin at byte 0; those of a BMP picture must begin after its header,"
                        + " at byte 54 or later");
    }

    @ParameterizedTest
    @CsvSource({"-2, 2", "2, 0", "100000, 100000", "2, -2147483648"})
    void theSizeIsCheckedForAllBits(int width, int height) {
        for (int bits : new int[] {1, 4, 8, 16, 24, 32}) {
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

    @Test
    void aPictureInsideIsRead() throws IOException {
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0xff0033);
        assertPixels(bmp(40, 2, 1, 0, 5, new byte[0], Samples.encoded("png", image)), 1, 0, 0.2, 1, 0, 0, 0, 1);
        BufferedImage white = new BufferedImage(2, 1, BufferedImage.TYPE_BYTE_GRAY);
        white.getRaster().setSample(0, 0, 0, 255);
        white.getRaster().setSample(1, 0, 0, 255);
        assertPixels(bmp(40, 2, 1, 0, 4, new byte[0], Samples.encoded("jpeg", white)), 1, 1, 1, 1, 1, 1, 1, 1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "64|24|0|has a header of 64 bytes, as OS/2 writes it; that of a BMP picture must have 12, 40, 52, 56, 108 or 124",
                "41|24|0|has a header of 41 bytes; that of a BMP picture must have 12, 40, 52, 56, 108 or 124",
                "40|2|0|has 2 bits a pixel; a BMP picture must have 1, 4, 8, 16, 24 or 32",
                "40|64|0|has 64 bits a pixel; a BMP picture must have 1, 4, 8, 16, 24 or 32",
                "40|24|11|its compression is number 11; a BMP picture must have none, run lengths, masks, JPEG or PNG (0 to 6)",
                "40|32|1|has run lengths and 32 bits a pixel; run lengths are for 8",
                "40|24|1|has run lengths and 24 bits a pixel; run lengths are for 8",
                "40|1|1|has run lengths and 1 bit a pixel; run lengths are for 8",
                "40|4|1|has run lengths and 4 bits a pixel; run lengths are for 8",
                "40|8|2|has run lengths and 8 bits a pixel; run lengths are for 4",
                "40|24|3|has masks and 24 bits a pixel; masks are for 16 and 32",
                "40|8|6|has masks and 8 bits a pixel; masks are for 16 and 32"
            })
    void whatIsNotReadIsNamed(int header, int bits, int compression, String reason) {
        byte[] file = bmp(header, 1, 1, bits, compression, new byte[0], new byte[64]);
        assertThatThrownBy(() -> PictureFile.read(file, "p.bmp"))
                .isInstanceOf(FileException.class)
                .hasMessage("p.bmp: " + reason);
    }

    @Test
    void bitsThatLieApartAreNamed() {
        byte[] file = bmp(40, 1, 1, 16, MASKS, ints(0xf00f, 0xf0, 0xf00), new byte[4]);
        assertThatThrownBy(() -> PictureFile.read(file, "p.bmp"))
                .hasMessage("p.bmp: the bits of a channel lie apart in its mask f00f;"
                        + " those of a BMP picture must lie together");
    }
}
