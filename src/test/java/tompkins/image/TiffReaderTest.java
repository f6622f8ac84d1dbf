package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ProcessorTime;
import tompkins.file.FileException;

class TiffReaderTest {

    private static final int WIDTH = 11;
    private static final int HEIGHT = 7;
    private static final List<ByteOrder> ORDERS = List.of(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN);

    /** Every level of few bits, and levels all over the range of many; the last is the largest. */
    private static TiffSample.Codes levels(int bits) {
        long largest = (1L << bits) - 1;
        return (x, y, sample) -> x == WIDTH - 1 ? largest : (x * 2654435761L + y * 40503L + sample * 977L) & largest;
    }

    private static void assertPixels(byte[] file, Expected expected) throws IOException {
        assertPixels(file, expected, 1e-6f);
    }

    private static void assertPixels(byte[] file, Expected expected, float tolerance) throws IOException {
        Pixels pixels = TiffReader.read(file, "p.tif");
        assertThat(new int[] {pixels.width(), pixels.height()}).containsExactly(WIDTH, HEIGHT);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                int at = 4 * (y * WIDTH + x);
                assertThat(Arrays.copyOfRange(pixels.rgba(), at, at + 4))
                        .as("pixel %d, %d", x, y)
                        .containsExactly(expected.at(x, y), within(tolerance));
            }
        }
    }

    private interface Expected {
        float[] at(int x, int y);
    }

    /** Every number of bits in every arrangement: strips and tiles, both byte orders, together and in planes. */
    private static Stream<TiffSample> arrangements(int photometric, int[] bits, TiffSample.Codes codes) {
        Supplier<TiffSample> plain = () -> new TiffSample(WIDTH, HEIGHT, photometric, bits, codes);
        return ORDERS.stream()
                .flatMap(order -> Stream.of(
                                plain.get(),
                                plain.get().strips(3),
                                plain.get().tiles(16, 16),
                                plain.get().tiles(4, 5),
                                plain.get().planar(),
                                plain.get().planar().strips(2),
                                plain.get().planar().tiles(4, 5),
                                plain.get().strips(3).compression(TiffSample.DEFLATE, 1),
                                plain.get().tiles(4, 5).compression(TiffSample.LZW, 1))
                        .map(sample -> sample.order(order)));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 8, 16})
    void theLargestNumberIsThatOfItsBits(int bits) throws IOException {
        TiffSample.Codes codes = levels(bits);
        double largest = (1L << bits) - 1;
        for (TiffSample sample :
                arrangements(1, TiffSample.bits(1, bits), codes).toList()) {
            assertPixels(sample.bytes(), (x, y) -> grey((float) (codes.at(x, y, 0) / largest)));
        }
        for (TiffSample sample :
                arrangements(0, TiffSample.bits(1, bits), codes).toList()) {
            assertPixels(sample.bytes(), (x, y) -> grey((float) (1 - codes.at(x, y, 0) / largest)));
        }
        List<TiffSample> colours = bits < 8
                ? List.of()
                : arrangements(2, TiffSample.bits(3, bits), codes).toList();
        for (TiffSample sample : colours) {
            assertPixels(sample.bytes(), (x, y) -> new float[] {
                (float) (codes.at(x, y, 0) / largest),
                (float) (codes.at(x, y, 1) / largest),
                (float) (codes.at(x, y, 2) / largest),
                1
            });
        }
    }

    private static float[] grey(float light) {
        return new float[] {light, light, light, 1};
    }

    @ParameterizedTest
    @CsvSource({"5, 1", "5, 2", "8, 1", "8, 2", "32946, 1", "32773, 1"})
    void packedSamplesAreUnpacked(int compression, int predictor) throws IOException {
        for (ByteOrder order : ORDERS) {
            for (int bits : new int[] {8, 16}) {
                TiffSample.Codes codes = levels(bits);
                double largest = (1L << bits) - 1;
                TiffSample sample = new TiffSample(WIDTH, HEIGHT, 2, TiffSample.bits(4, bits), codes)
                        .order(order)
                        .strips(2)
                        .compression(compression == 32946 ? TiffSample.DEFLATE : compression, predictor)
                        .tag(259, compression)
                        .tag(338, 2);
                assertPixels(sample.bytes(), (x, y) -> new float[] {
                    (float) (codes.at(x, y, 0) / largest),
                    (float) (codes.at(x, y, 1) / largest),
                    (float) (codes.at(x, y, 2) / largest),
                    (float) (codes.at(x, y, 3) / largest)
                });
            }
        }
    }

    @Test
    void reversedBitsAreTurned() throws IOException {
        TiffSample.Codes codes = levels(4);
        TiffSample sample = new TiffSample(WIDTH, HEIGHT, 1, new int[] {4}, codes).bitsReversed();
        assertPixels(sample.bytes(), (x, y) -> grey(codes.at(x, y, 0) / 15f));
    }

    /** Values that no whole number has, and more than white. */
    @Test
    void floatingPointIsTakenAsItIs() throws IOException {
        float[] light = {0, 1, 0.5f, 2, 0x1p-24f, 65504, 0.333251953125f, -0.25f, 3, 1025, 7};
        TiffSample.Codes codes = (x, y, s) -> Float.floatToIntBits(light[x]) & 0xffffffffL;
        for (TiffSample sample : arrangements(1, TiffSample.bits(1, 32), codes).toList()) {
            assertPixels(sample.tag(339, 3).bytes(), (x, y) -> grey(light[x]));
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY})
    void whatIsNoNumberOfLightIsNamed(float light) {
        TiffSample.Codes codes = (x, y, s) -> Float.floatToRawIntBits(x == 3 && y == 2 ? light : 0.5f) & 0xffffffffL;
        TiffSample sample = new TiffSample(WIDTH, HEIGHT, 1, new int[] {32}, codes).tag(339, 3);
        assertThatThrownBy(() -> PictureFile.read(sample.bytes(), "p.tif"))
                .hasMessage("p.tif: pixel (3, 2) has a value of " + light + "; those of a picture must be finite");
    }

    @Test
    void bytesOfDifferencesAreFloatingPoint() throws IOException {
        // Written by hand: 1.5 = 3fc00000, 2 = 40000000; all highest bytes first, then differences.
        byte[] sorted = {0x3f, 0x40, (byte) 0xc0, 0, 0, 0, 0, 0};
        long[] stored = new long[8];
        for (int i = 0; i < 8; i++) {
            stored[i] = Byte.toUnsignedInt((byte) (sorted[i] - (i > 0 ? sorted[i - 1] : 0)));
        }
        for (ByteOrder order : ORDERS) {
            byte[] file = new TiffSample(8, 1, 1, new int[] {8}, (x, y, s) -> stored[x])
                    .order(order)
                    .compression(TiffSample.DEFLATE, 1)
                    .tag(256, 2)
                    .tag(258, 32)
                    .tag(339, 3)
                    .tag(317, 3)
                    .bytes();
            assertThat(TiffReader.read(file, "p.tif").rgba()).containsExactly(1.5f, 1.5f, 1.5f, 1, 2, 2, 2, 1);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void opacityThatIsAssociatedIsDividedOut(int bits) throws IOException {
        long largest = (1L << bits) - 1;
        TiffSample.Codes codes =
                (x, y, s) -> s == 3 || x == 0 ? largest - (x == 0 ? 0 : largest / 2) : largest / (3 + s);
        for (int kind : new int[] {1, 2}) {
            for (TiffSample sample :
                    arrangements(2, TiffSample.bits(4, bits), codes).toList()) {
                float opacity = (float) ((largest - largest / 2) / (double) largest);
                float divisor = kind == 1 ? opacity : 1;
                assertPixels(
                        sample.tag(338, kind).bytes(),
                        (x, y) -> x == 0
                                ? new float[] {1, 1, 1, 1}
                                : new float[] {
                                    (float) (largest / 3 / (double) largest) / divisor,
                                    (float) (largest / 4 / (double) largest) / divisor,
                                    (float) (largest / 5 / (double) largest) / divisor,
                                    opacity
                                });
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void greyMayHaveOpacity(int bits) throws IOException {
        long largest = (1L << bits) - 1;
        TiffSample.Codes codes = (x, y, s) -> s == 0 ? largest / 3 : largest - largest / 4;
        float level = (float) (largest / 3 / (double) largest);
        float opacity = (float) ((largest - largest / 4) / (double) largest);
        for (TiffSample sample :
                arrangements(1, TiffSample.bits(2, bits), codes).toList()) {
            float divided = level / opacity;
            assertPixels(sample.tag(338, 1).bytes(), (x, y) -> new float[] {divided, divided, divided, opacity});
            assertPixels(sample.tag(338, 2).bytes(), (x, y) -> new float[] {level, level, level, opacity});
        }
        for (TiffSample sample :
                arrangements(0, TiffSample.bits(2, bits), codes).toList()) {
            float light = 1 - level;
            assertPixels(sample.tag(338, 2).bytes(), (x, y) -> new float[] {light, light, light, opacity});
            assertPixels(sample.tag(338, 1).bytes(), (x, y) ->
                    new float[] {light / opacity, light / opacity, light / opacity, opacity});
        }
    }

    @Test
    void floatingPointMayHaveOpacity() throws IOException {
        float[] floats = {0.25f, 0.5f, 0.125f, 0.5f};
        TiffSample.Codes bits = (x, y, s) -> Float.floatToIntBits(floats[s]) & 0xffffffffL;
        TiffSample light = new TiffSample(WIDTH, HEIGHT, 2, TiffSample.bits(4, 32), bits).tag(339, 3, 3, 3, 3);
        assertPixels(light.tag(338, 1).bytes(), (x, y) -> new float[] {0.5f, 1, 0.25f, 0.5f});
    }

    @ParameterizedTest
    @ValueSource(floats = {-0.5f, 1.5f})
    void whatIsNoOpacityIsNamed(float opacity) {
        TiffSample.Codes bits = (x, y, s) -> Float.floatToIntBits(s == 3 ? opacity : 0.5f) & 0xffffffffL;
        TiffSample sample = new TiffSample(WIDTH, HEIGHT, 2, TiffSample.bits(4, 32), bits).tag(339, 3, 3, 3, 3);
        assertThatThrownBy(() -> PictureFile.read(sample.tag(338, 2).bytes(), "p.tif"))
                .hasMessage("p.tif: pixel (0, 0) has an opacity of " + opacity + "; opacities must be from 0 to 1");
    }

    /** Levels of 16 bits, of which 8 would lose some. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 8})
    void aPaletteIsLookedUp(int bits) throws IOException {
        int colours = 1 << bits;
        long[] map = new long[3 * colours];
        for (int i = 0; i < colours; i++) {
            map[i] = i * 65535L / (colours - 1);
            map[colours + i] = 65535 - map[i];
            map[2 * colours + i] = i == 1 ? 12345 : 0;
        }
        TiffSample.Codes codes = (x, y, s) -> x % colours;
        Expected opaque = (x, y) -> new float[] {
            map[x % colours] / 65535f, map[colours + x % colours] / 65535f, x % colours == 1 ? 12345 / 65535f : 0, 1
        };
        for (TiffSample sample :
                arrangements(3, TiffSample.bits(1, bits), codes).toList()) {
            assertPixels(sample.tag(320, map).bytes(), opaque);
        }
    }

    @Test
    void aPaletteOfBytesIsUnderstood() throws IOException {
        long[] map = {0, 255, 0, 51, 0, 102};
        TiffSample sample = new TiffSample(WIDTH, HEIGHT, 3, new int[] {1}, (x, y, s) -> x & 1).tag(320, map);
        assertPixels(
                sample.bytes(), (x, y) -> (x & 1) == 0 ? new float[] {0, 0, 0, 1} : new float[] {1, 0.2f, 0.4f, 1});
    }

    /** Where the pixel in the first row and first column lies, by the table in TIFF 6.0, page 36. */
    @ParameterizedTest
    @CsvSource({
        "1, 0, 0, 2, 0",
        "2, 2, 0, 0, 0",
        "3, 2, 1, 0, 1",
        "4, 0, 1, 2, 1",
        "5, 0, 0, 0, 2",
        "6, 1, 0, 1, 2",
        "7, 1, 2, 1, 0",
        "8, 0, 2, 0, 0",
        "0, 0, 0, 2, 0",
        "9, 0, 0, 2, 0"
    })
    void aPictureIsTurned(int orientation, int x, int y, int lastX, int lastY) throws IOException {
        byte[] file = new TiffSample(
                        3,
                        2,
                        1,
                        new int[] {8},
                        (column, row, s) -> row > 0 ? 0 : column == 0 ? 255 : column == 2 ? 51 : 0)
                .tag(274, orientation)
                .bytes();

        Pixels pixels = TiffReader.read(file, "p.tif");

        boolean upright = orientation >= 5 && orientation <= 8;
        assertThat(pixels.width()).isEqualTo(upright ? 2 : 3);
        assertThat(pixels.height()).isEqualTo(upright ? 3 : 2);
        assertThat(pixels.rgba()[4 * (y * pixels.width() + x)]).isEqualTo(1);
        assertThat(pixels.rgba()[4 * (lastY * pixels.width() + lastX)]).isEqualTo(0.2f);
    }

    @ParameterizedTest
    @MethodSource
    void whatIsNotReadIsNamed(TiffSample sample, String reason) {
        assertThatThrownBy(() -> PictureFile.read(sample.bytes(), "p.tif"))
                .isInstanceOf(FileException.class)
                .hasMessageStartingWith("p.tif: " + reason);
    }

    static List<Arguments> whatIsNotReadIsNamed() {
        return List.of(
                Arguments.of(plain(1, 8).tag(339, 2), "has signed samples of 8 bits; "),
                Arguments.of(plain(1, 8).tag(339, 5), "has complex signed samples of 8 bits; "),
                Arguments.of(plain(1, 8).tag(339, 7), "has unknown samples of 8 bits; "),
                Arguments.of(plain(3, 8).tag(258, 5, 6, 5), "has several kinds of samples; "),
                Arguments.of(plain(3, 32).tag(339, 3, 1, 3), "has several kinds of samples; "),
                Arguments.of(plain(1, 24).tag(339, 3), "has floating-point samples of 24 bits; "),
                Arguments.of(plain(1, 64).tag(339, 3), "has floating-point samples of 64 bits; "),
                Arguments.of(plain(1, 32).tag(339, 3).tag(262, 0), "has floating-point samples of 32 bits; "),
                Arguments.of(plain(3, 4), "has unsigned samples of 4 bits; "),
                Arguments.of(plain(1, 16).tag(262, 3), "has unsigned samples of 16 bits; "),
                Arguments.of(plain(1, 8).tag(259, 7), "has compression number 7; "),
                Arguments.of(plain(4, 8).tag(262, 5), "has colours of kind 5; "),
                Arguments.of(plain(1, 8).tag(259, 5).tag(317, 4), "has predictor 4 for unsigned samples of 8 bits; "),
                Arguments.of(plain(1, 4).tag(259, 5).tag(317, 2), "has predictor 2 for unsigned samples of 4 bits; "),
                Arguments.of(plain(1, 16).tag(259, 5).tag(317, 3), "has predictor 3 for unsigned samples of 16 bits; "),
                Arguments.of(plain(1, 8).tag(259, 32773).tag(317, 2), "has predictor 2 for unsigned samples of 8 bits"),
                Arguments.of(
                        plain(1, 32).tag(339, 3).tag(259, 8).tag(317, 2),
                        "has predictor 2 for floating-point samples of 32"),
                Arguments.of(plain(1, 8).tag(262, 2), "has 1 samples a pixel for 3 of colour; "),
                Arguments.of(plain(4, 8).tag(338, 0), "has 4 samples a pixel for 3 of colour; "),
                Arguments.of(
                        plain(1, 8).tiles(16, 16).tag(322, 1L << 31),
                        "has tiles of 2147483648 x 16 pixels; a TIFF picture"),
                Arguments.of(plain(1, 8).tag(278, 0), "has strips of 11 x 0 pixels; "));
    }

    private static TiffSample plain(int samples, int bits) {
        return new TiffSample(WIDTH, HEIGHT, samples < 3 ? 1 : 2, TiffSample.bits(samples, bits), (x, y, s) -> 1);
    }

    /** The third part of seven, of which the library would show what else is in the file. */
    @ParameterizedTest
    @MethodSource
    void missingBytesAreNotShown(boolean tiled, int compression, int tag, long value, String reason) {
        TiffSample sample = new TiffSample(12, 28, 1, new int[] {8}, levels(8)).compression(compression, 1);
        byte[] file = (tiled ? sample.tiles(12, 4) : sample.strips(4)).bytes();
        replace(file, tiled ? tag == 273 ? 324 : 325 : tag, 2, value < 0 ? file.length + value : value);

        String part = tiled ? "tile" : "strip";
        assertThatThrownBy(() -> PictureFile.read(file, "p.tif"))
                .isInstanceOf(FileException.class)
                .hasMessageMatching("p.tif: TIFF picture cannot be read: " + reason.replace("PART", part));
    }

    static Stream<Object[]> missingBytesAreNotShown() {
        int offsets = 273;
        int sizes = 279;
        String place = "PART \\d is said to lie at byte \\d+ and to have \\d+, ";
        String outside = place + "but the file ends before";
        String taken = place + "where the file has something else";
        return Stream.of(true, false)
                .flatMap(tiled -> Stream.of(TiffSample.NONE, TiffSample.LZW, TiffSample.DEFLATE, TiffSample.PACK_BITS)
                        .flatMap(packing -> {
                            String less = packing == TiffSample.NONE
                                    ? "bytes are missing: PART 2 has 10, and needs 48"
                                    : "the file ends too early or contradicts itself";
                            String none = "bytes are missing: PART 2 has 0, and needs "
                                    + (packing == TiffSample.NONE ? "48" : "some");
                            return Stream.of(
                                    new Object[] {tiled, packing, sizes, 10, less},
                                    new Object[] {tiled, packing, sizes, 0, none},
                                    new Object[] {tiled, packing, sizes, 1L << 31, outside},
                                    new Object[] {tiled, packing, offsets, 0, taken},
                                    new Object[] {tiled, packing, offsets, 8, taken},
                                    new Object[] {tiled, packing, offsets, -1, outside},
                                    new Object[] {tiled, packing, offsets, 1L << 31, outside},
                                    new Object[] {tiled, packing, offsets, -60, place + ".*"});
                        }));
    }

    /** Writes another number into a tag of a file of little endian that has several in it. */
    private static void replace(byte[] file, int tag, int index, long value) {
        ByteBuffer tags = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        int at = 10;
        while (Short.toUnsignedInt(tags.getShort(at)) != tag) {
            at += 12;
        }
        tags.putInt(tags.getInt(at + 8) + 4 * index, (int) value);
    }

    /** Without packing there is no predictor, whatever the tag says. */
    @Test
    void aPredictorWithoutPackingSaysNothing() throws IOException {
        TiffSample.Codes codes = levels(8);
        byte[] file = new TiffSample(WIDTH, HEIGHT, 1, new int[] {8}, codes)
                .tag(317, 2)
                .bytes();
        assertPixels(file, (x, y) -> grey(codes.at(x, y, 0) / 255f));
    }

    /** A strip of its own for each row, as scanners write them: each is handed to the library. */
    @Test
    void manyPackedStripsTakeLittleTime() throws IOException {
        byte[] many = packedStrips(5_000);
        byte[] few = packedStrips(500);
        assertThat(TiffReader.read(many, "p.tif").height()).isEqualTo(5_000);
        double ratio = ProcessorTime.ratio(() -> TiffReader.read(many, "p.tif"), () -> TiffReader.read(few, "p.tif"));
        assertThat(ratio).as("of 10 times as many").isLessThan(40);
    }

    private static byte[] packedStrips(int count) throws IOException {
        return new TiffSample(8, count, 1, new int[] {8}, (x, y, s) -> x)
                .strips(1)
                .compression(TiffSample.PACK_BITS, 1)
                .bytes();
    }

    /** Some programs list tiles as if they were strips. */
    @Test
    void tilesMayBeListedAsStrips() throws IOException {
        TiffSample.Codes codes = levels(8);
        byte[] file = new TiffSample(WIDTH, HEIGHT, 1, new int[] {8}, codes)
                .tiles(4, 5)
                .bytes();
        ByteBuffer tags = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        for (int at = 10; at < 10 + 12 * tags.getShort(8); at += 12) {
            int tag = Short.toUnsignedInt(tags.getShort(at));
            tags.putShort(at, (short) (tag == 324 ? 273 : tag == 325 ? 279 : tag));
        }
        assertPixels(file, (x, y) -> grey(codes.at(x, y, 0) / 255f));
    }

    @Test
    void aBigTiffIsRead() throws IOException {
        ByteBuffer file = ByteBuffer.allocate(300).order(ByteOrder.LITTLE_ENDIAN);
        long[][] tags = {{256, 2}, {257, 1}, {258, 8}, {259, 1}, {262, 1}, {273, 280}, {277, 1}, {278, 1}, {279, 2}};
        file.put((byte) 'I')
                .put((byte) 'I')
                .putShort((short) 43)
                .putShort((short) 8)
                .putShort((short) 0)
                .putLong(16);
        file.putLong(tags.length);
        for (long[] tag : tags) {
            file.putShort((short) tag[0]).putShort((short) 16).putLong(1).putLong(tag[1]);
        }
        file.putLong(0).position(280).put((byte) 0xff).put((byte) 0x80);
        assertThat(TiffReader.read(file.array(), "p.tif").rgba())
                .containsExactly(new float[] {1, 1, 1, 1, 128 / 255f, 128 / 255f, 128 / 255f, 1}, within(1e-7f));
    }
}
