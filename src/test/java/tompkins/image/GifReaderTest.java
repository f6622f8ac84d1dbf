package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class GifReaderTest {

    private static final int[] RED_AND_GREEN = {255, 0, 0, 0, 255, 0};
    private static final int[] BLUE_AND_GREY = {0, 0, 255, 51, 51, 51};

    private final ByteArrayOutputStream file = new ByteArrayOutputStream();

    /** Begins a file with a palette, which is empty for none. */
    private GifReaderTest screen(int width, int height, int... palette) {
        put('G', 'I', 'F', '8', '9', 'a', width, width >> 8, height, height >> 8);
        return put(palette.length > 0 ? 0x80 : 0, 0, 0).put(palette);
    }

    private GifReaderTest put(int... bytes) {
        for (int value : bytes) {
            file.write(value);
        }
        return this;
    }

    private GifReaderTest transparent(int colour) {
        return put(0x21, 0xf9, 4, 1, 0, 0, colour, 0);
    }

    /** A frame of two colours, whose codes have 3 bits and are cleared before they would need more. */
    private GifReaderTest frame(int left, int top, int width, int height, int flags, int[] palette, String pixels) {
        put(0x2c, left, 0, top, 0, width, 0, height, 0, flags | (palette.length > 0 ? 0x80 : 0));
        put(palette).put(2);
        StringBuilder bits = new StringBuilder();
        for (int i = 0; i < pixels.length(); i++) {
            bits.insert(0, i % 2 == 0 ? "100" : "").insert(0, pixels.charAt(i) == '1' ? "001" : "000");
        }
        bits.insert(0, "101").insert(0, "0".repeat((8 - bits.length() % 8) % 8));
        // In blocks of a single byte each.
        for (int to = bits.length(); to > 0; to -= 8) {
            put(1, Integer.parseInt(bits.substring(to - 8, to), 2));
        }
        return put(0);
    }

    private Pixels read() throws IOException {
        return GifReader.read(file.toByteArray(), "p.gif");
    }

    private void assertPixels(int width, double... rgba) throws IOException {
        float[] expected = new float[rgba.length];
        for (int i = 0; i < rgba.length; i++) {
            expected[i] = (float) rgba[i];
        }
        Pixels pixels = read();
        assertThat(pixels.width()).isEqualTo(width);
        assertThat(pixels.rgba()).containsExactly(expected, within(1e-6f));
    }

    private void assertRefused(String reason) {
        assertThatThrownBy(() -> PictureFile.read(file.toByteArray(), "p.gif"))
                .isInstanceOf(FileException.class)
                .hasMessage("p.gif: " + reason);
    }

    /** What is around a frame is transparent, and later frames do not count. */
    @Test
    void aFrameLiesInItsPlaceOnTheScreen() throws IOException {
        screen(3, 2, RED_AND_GREEN).frame(1, 1, 2, 1, 0, new int[0], "01");
        frame(0, 0, 3, 2, 0, new int[0], "111111").put(0x3b);
        assertPixels(3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 1);
    }

    @Test
    void aScreenGrowsWithItsFrame() throws IOException {
        screen(1, 1, RED_AND_GREEN).frame(1, 0, 1, 1, 0, new int[0], "1");
        assertPixels(2, 0, 0, 0, 0, 0, 1, 0, 1);
    }

    @Test
    void thePaletteOfTheFrameComesFirst() throws IOException {
        screen(2, 1, RED_AND_GREEN).frame(0, 0, 2, 1, 0, BLUE_AND_GREY, "01");
        assertPixels(2, 0, 0, 1, 1, 0.2, 0.2, 0.2, 1);
    }

    /** Comments and other extensions say nothing; a transparent colour need not be in the palette. */
    @ParameterizedTest
    @CsvSource({"0, 0, 1", "1, 1, 0", "200, 1, 1"})
    void aColourMayBeTransparent(int colour, double red, double green) throws IOException {
        screen(2, 1, RED_AND_GREEN).put(0x21, 0xfe, 2, 'h', 'i', 1, ',', 0).transparent(colour);
        put(0x21, 0xff, 3, 1, 2, 3, 0).frame(0, 0, 2, 1, 0, new int[0], "01");
        assertPixels(2, 1, 0, 0, red, 0, 1, 0, green);
    }

    /** Rows 0, 8 and so on, then 4, then 2 and 6, then all that are odd (GIF89a, appendix E). */
    @ParameterizedTest
    @CsvSource({"1, 0", "2, 01", "3, 021", "4, 0213", "5, 04213", "7, 0426135", "9, 084261357"})
    void interlacedRowsArePutInOrder(int height, String order) throws IOException {
        for (int marked = 0; marked < height; marked++) {
            file.reset();
            StringBuilder pixels = new StringBuilder("0".repeat(height)).replace(marked, marked + 1, "1");
            screen(1, height, RED_AND_GREEN).frame(0, 0, 1, height, 0x40, new int[0], pixels.toString());
            float[] rgba = read().rgba();
            for (int y = 0; y < height; y++) {
                boolean green = order.charAt(marked) - '0' == y;
                assertThat(rgba[4 * y + 1]).as("%d at %d", marked, y).isEqualTo(green ? 1 : 0);
            }
        }
    }

    /** Long chains, all sizes of codes and a full table, as the JDK's writer packs them. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 16, 200, 256})
    void chainsOfAllLengthsAreUnpacked(int colours) throws IOException {
        BufferedImage image = new BufferedImage(170, 130, BufferedImage.TYPE_BYTE_INDEXED);
        Random random = new Random(colours);
        for (int y = 0; y < 130; y++) {
            for (int x = 0; x < 170; x++) {
                image.getRaster().setSample(x, y, 0, y < 40 ? y % colours : random.nextInt(colours));
            }
        }
        Pixels pixels = GifReader.read(Samples.encoded("gif", image), "p.gif");
        for (int i = 0; i < 170 * 130; i++) {
            int rgb = image.getRGB(i % 170, i / 170);
            float[] expected = {(rgb >> 16 & 0xff) / 255f, (rgb >> 8 & 0xff) / 255f, (rgb & 0xff) / 255f, 1};
            assertThat(Arrays.copyOfRange(pixels.rgba(), 4 * i, 4 * i + 4)).containsExactly(expected);
        }
    }

    /** The end comes too early, inside the blocks and before them. */
    @ParameterizedTest
    @ValueSource(strings = {"0", "01", "010"})
    void missingPixelsAreNoPicture(String pixels) {
        screen(2, 2, RED_AND_GREEN).frame(0, 0, 2, 2, 0, new int[0], pixels).put(0x3b);
        assertRefused("GIF picture cannot be read: the file ends too early or contradicts itself");
    }

    @Test
    void whatIsWrongIsNamed() {
        screen(1, 1).frame(0, 0, 1, 1, 0, new int[0], "0");
        assertRefused("has no palette; a GIF picture must have one");
        assertRefused("3b", "GIF picture cannot be read: it has no picture");
        assertRefused(
                "2c 00 00 00 00 01 00 01 00 00 09 01 00 00",
                "GIF picture cannot be read: its colours have 9 bits, and must have from 1 to 8");
        assertRefused(
                "2c 00 00 00 00 01 00 01 00 00 02 01 3c 00",
                "GIF picture cannot be read: a code of its pixels stands for nothing");
        assertRefused(
                "2c 00 00 00 00 01 00 01 00 00 02 01 1c 00",
                "GIF picture cannot be read: a pixel's colour is not in the palette");
        assertRefused(
                "2c 00 00 00 00 00 00 01 00 00 02 01 1c 00",
                "claims to have 0 x 1 pixels; a picture may have from 1 to 64000000");
    }

    /**
     * A picture of one pixel is refused.
     *
     * @param bytes what follows its palette, as hexadecimal numbers
     */
    private void assertRefused(String bytes, String reason) {
        file.reset();
        screen(1, 1, RED_AND_GREEN);
        file.writeBytes(HexFormat.ofDelimiter(" ").parseHex(bytes));
        assertRefused(reason);
    }
}
