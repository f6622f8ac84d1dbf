package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeout;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

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
        return ORDERS.stream()
                .flatMap(order -> Stream.of(
                                new TiffSample(WIDTH, HEIGHT, photometric, bits, codes),
                                new TiffSample(WIDTH, HEIGHT, photometric, bits, codes).strips(3),
                                new TiffSample(WIDTH, HEIGHT, photometric, bits, codes).tiles(16, 16),
                                new TiffSample(WIDTH, HEIGHT, photometric, bits, codes).tiles(4, 5),
                                new TiffSample(WIDTH, HEIGHT, photometric, bits, codes).planar(),
                                new TiffSample(WIDTH, HEIGHT, photometric, bits, codes)
                                        .planar()
                                        .strips(2),
                                new TiffSample(WIDTH, HEIGHT, photometric, bits, codes)
                                        .planar()
                                        .tiles(4, 5),
                                new TiffSample(WIDTH, HEIGHT, photometric, bits, codes)
                                        .strips(3)
                                        .compression(TiffSample.DEFLATE, 1),
                                new TiffSample(WIDTH, HEIGHT, photometric, bits, codes)
                                        .tiles(4, 5)
                                        .compression(TiffSample.LZW, 1))
                        .map(sample -> sample.order(order)));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 18, 20, 22, 24, 28, 31, 32})
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
        for (TiffSample sample :
                arrangements(2, TiffSample.bits(3, bits), codes).toList()) {
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

    @Test
    void channelsMayHaveTheirOwnBits() throws IOException {
        int[] bits = {5, 6, 5, 1};
        TiffSample sample =
                new TiffSample(WIDTH, HEIGHT, 2, bits, (x, y, s) -> s < 3 ? x + 20 * (s % 2) : y & 1).tag(338, 2);
        assertPixels(sample.bytes(), (x, y) -> new float[] {x / 31f, (x + 20) / 63f, x / 31f, y & 1});
    }

    @ParameterizedTest
    @CsvSource({"5, 1", "5, 2", "8, 1", "8, 2", "32946, 1", "32773, 1"})
    void packedSamplesAreUnpacked(int compression, int predictor) throws IOException {
        for (ByteOrder order : ORDERS) {
            for (int bits : new int[] {8, 16, 32}) {
                TiffSample.Codes codes = levels(bits);
                double largest = (1L << bits) - 1;
                TiffSample sample = new TiffSample(WIDTH, HEIGHT, 2, TiffSample.bits(4, bits), codes)
                        .order(order)
                        .strips(2)
                        .compression(compression == 32946 ? TiffSample.DEFLATE : compression, predictor)
                        .tag(259, compression)
                        .tag(338, 0);
                assertPixels(sample.bytes(), (x, y) -> new float[] {
                    (float) (codes.at(x, y, 0) / largest),
                    (float) (codes.at(x, y, 1) / largest),
                    (float) (codes.at(x, y, 2) / largest),
                    1
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

    /** Floating point of 16, 32 and 64 bits, with values that no whole number has. */
    @Test
    void floatingPointIsTakenAsItIs() throws IOException {
        float[] light = {0, 1, 0.5f, 2, 0x1p-24f, 65504, 0.333251953125f, -0.25f, 3, 1025, 7};
        long[] halves = {0, 0x3c00, 0x3800, 0x4000, 1, 0x7bff, 0x3555, 0xb400, 0x4200, 0x6401, 0x4700};
        for (ByteOrder order : ORDERS) {
            for (int bits : new int[] {16, 32, 64}) {
                TiffSample.Codes codes = (x, y, s) -> bits == 16
                        ? halves[x]
                        : bits == 32 ? Float.floatToIntBits(light[x]) & 0xffffffffL : Double.doubleToLongBits(light[x]);
                TiffSample sample = new TiffSample(WIDTH, HEIGHT, 1, new int[] {bits}, codes)
                        .order(order)
                        .tag(339, 3);
                assertPixels(sample.bytes(), (x, y) -> grey(light[x]));
                assertPixels(sample.tag(262, 0).bytes(), (x, y) -> grey(1 - light[x]));
            }
        }
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
    @ValueSource(ints = {1, 2, 4, 8, 12, 16, 32})
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
    @ValueSource(ints = {1, 4, 8, 16})
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
            assertPixels(sample.tag(338, 0).bytes(), (x, y) -> grey(level));
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
    void opacityMayComeAfterOtherSamples() throws IOException {
        TiffSample sample = new TiffSample(WIDTH, HEIGHT, 2, TiffSample.bits(6, 8), (x, y, s) -> 10 * s + x);
        assertPixels(sample.tag(338, 0, 2, 0).bytes(), (x, y) ->
                new float[] {x / 255f, (10 + x) / 255f, (20 + x) / 255f, (40 + x) / 255f});
        float[] floats = {0.25f, 0.5f, 0.125f, 0.5f};
        TiffSample.Codes bits = (x, y, s) -> Float.floatToIntBits(floats[s]) & 0xffffffffL;
        TiffSample light = new TiffSample(WIDTH, HEIGHT, 2, TiffSample.bits(4, 32), bits).tag(339, 3, 3, 3, 3);
        assertPixels(light.tag(338, 1).bytes(), (x, y) -> new float[] {0.5f, 1, 0.25f, 0.5f});
    }

    /** Levels of 16 bits, of which 8 would lose some. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 6, 8, 12, 16})
    void aPaletteMayHaveOpacity(int bits) throws IOException {
        int colours = 1 << bits;
        long[] map = new long[3 * colours];
        for (int i = 0; i < colours; i++) {
            map[i] = i * 65535L / (colours - 1);
            map[colours + i] = 65535 - map[i];
            map[2 * colours + i] = i == 1 ? 12345 : 0;
        }
        TiffSample.Codes codes = (x, y, s) -> s == 0 ? x % colours : (y == 0 ? 0 : (1L << bits) - 1);
        Expected opaque = (x, y) -> new float[] {
            map[x % colours] / 65535f, map[colours + x % colours] / 65535f, x % colours == 1 ? 12345 / 65535f : 0, 1
        };
        for (TiffSample sample :
                arrangements(3, TiffSample.bits(1, bits), codes).toList()) {
            assertPixels(sample.tag(320, map).bytes(), opaque);
        }
        for (int kind : new int[] {1, 2}) {
            for (TiffSample sample :
                    arrangements(3, TiffSample.bits(2, bits), codes).toList()) {
                assertPixels(sample.tag(320, map).tag(338, kind).bytes(), (x, y) -> {
                    float[] colour = opaque.at(x, y);
                    colour[3] = y == 0 ? 0 : 1;
                    return colour;
                });
            }
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
    @EnumSource
    void turningKeepsEveryPixel(Orientation orientation) {
        float[] rgba = new float[4 * 12];
        for (int i = 0; i < rgba.length; i++) {
            rgba[i] = i;
        }
        float[] turned = orientation.turn(new Pixels(4, 3, rgba)).rgba().clone();
        Arrays.sort(turned);
        assertThat(turned).containsExactly(rgba);
    }

    @ParameterizedTest
    @MethodSource
    void whatIsNotReadIsNamed(TiffSample sample, String reason) {
        assertThatThrownBy(() -> PictureFile.read(sample.bytes(), "p.tif"))
                .isInstanceOf(FileException.class)
                .hasMessageStartingWith("p.tif: " + reason);
    }

    static List<Object[]> whatIsNotReadIsNamed() {
        String signed = "its numbers are signed; those of a picture must be unsigned or floating point";
        return List.of(
                new Object[] {plain(1, 8).tag(339, 2), signed},
                new Object[] {plain(1, 16).tag(339, 2), signed},
                new Object[] {plain(3, 32).tag(339, 2, 2, 2), signed},
                new Object[] {plain(1, 8).tag(339, 5), "its numbers are complex; "},
                new Object[] {plain(1, 8).tag(339, 9), "its numbers are of an unknown kind (sample format 9); "},
                new Object[] {plain(3, 32).tag(339, 3, 1, 3), "has whole numbers and floating point in one pixel; "},
                new Object[] {plain(1, 24).tag(339, 3), "its numbers are floating point with 24 bits; "},
                new Object[] {plain(1, 8).tag(339, 3), "its numbers are floating point with 8 bits; "},
                new Object[] {plain(1, 64), "its numbers are whole numbers of 64 bits; "},
                new Object[] {plain(1, 8).tag(259, 50000), "its compression is Zstandard (50000); "},
                new Object[] {plain(1, 8).tag(259, 34925), "its compression is LZMA (34925); "},
                new Object[] {plain(3, 8).tag(259, 50001), "its compression is WebP (50001); "},
                new Object[] {plain(1, 8).tag(259, 4711), "its compression is number 4711; "},
                new Object[] {plain(4, 8).tag(262, 5), "its colours are inks, as cyan, magenta, yellow and black"},
                new Object[] {plain(3, 8).tag(262, 8), "its colours are CIE L*a*b* (photometric interpretation 8); "},
                new Object[] {
                    plain(3, 12).tag(262, 6),
                    "has 12 bits a sample, which a TIFF picture with its compression or its colours may not have"
                },
                new Object[] {
                    plain(1, 12).tag(259, 7),
                    "has 12 bits a sample, which a TIFF picture with its compression or its colours may not have"
                },
                new Object[] {
                    plain(1, 8).tag(259, 5).tag(317, 4),
                    "its predictor is number 4; that of a TIFF picture must be 1, 2"
                },
                new Object[] {
                    plain(1, 32).tag(259, 8).tag(317, 3), "its predictor is number 3, which is for floating point, and"
                },
                new Object[] {
                    plain(3, 8).tag(262, 6).tag(530, 3, 1),
                    "its chrominance is shared by 3 x 1 pixels; in a TIFF picture 1, 2 or 4 across and down may share"
                },
                new Object[] {
                    plain(4, 8).tag(262, 6),
                    "has 4 samples a pixel; a TIFF picture whose pixels share their chrominance must have 3"
                },
                new Object[] {
                    plain(3, 8).tag(262, 6).tag(530, 1, 1).tag(532, 9, 9, 128, 255, 128, 255),
                    "no colours follow from its luminance with the shares [0.299, 0.587, 0.114] and from black to white"
                            + " [9.0, 9.0, 128.0, 255.0, 128.0, 255.0]; "
                },
                new Object[] {
                    plain(4, 8).tag(259, 6),
                    "has 4 samples a pixel; a TIFF picture with JPEG of the old kind (compression 6) must have 3"
                },
                new Object[] {plain(1, 8).tag(262, 32803), "its colours are raw numbers of a camera"},
                new Object[] {plain(3, 16).tag(262, 34892), "its colours are raw numbers of a camera"},
                new Object[] {plain(3, 16).tag(262, 32845), "its colours are logarithms, SGI LogLuv"},
                new Object[] {plain(1, 1).tag(262, 4), "its colours are a mask for another picture"},
                new Object[] {
                    plain(1, 8).tag(262, 99), "its colours are of an unknown kind (photometric interpretation 99)"
                },
                new Object[] {plain(1, 8).tag(262, 2), "has 1 samples a pixel; its colours need from 3 to 256"},
                new Object[] {plain(1, 8).tag(256, 100_000).tag(257, 100_000), "claims to have 100000 x 100000 pixels"
                });
    }

    private static TiffSample plain(int samples, int bits) {
        return new TiffSample(WIDTH, HEIGHT, samples < 3 ? 1 : 2, TiffSample.bits(samples, bits), (x, y, s) -> 1);
    }

    /** The JDK writes these three, and what is black stays black. */
    @ParameterizedTest
    @ValueSource(strings = {"CCITT RLE", "CCITT T.4", "CCITT T.6"})
    void faxIsRead(String compression) throws IOException {
        BufferedImage image = new BufferedImage(37, 21, BufferedImage.TYPE_BYTE_BINARY);
        for (int i = 0; i < 37 * 21; i += 5) {
            image.setRGB(i % 37, i / 37, 0xffffff);
        }

        Pixels pixels = TiffReader.read(Samples.compressedTiff(image, compression), "p.tif");

        for (int i = 0; i < 37 * 21; i++) {
            assertThat(pixels.rgba()[4 * i]).as("pixel %d", i).isEqualTo(i % 5 == 0 ? 1 : 0);
        }
    }

    @Test
    void jpegInsideIsRead() throws IOException {
        BufferedImage image = new BufferedImage(32, 16, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 32 * 16; i++) {
            image.setRGB(i % 32, i / 32, 0x4080c0);
        }
        float[] rgba =
                TiffReader.read(Samples.compressedTiff(image, "JPEG"), "p.tif").rgba();
        assertThat(Arrays.copyOf(rgba, 4))
                .containsExactly(new float[] {64 / 255f, 128 / 255f, 192 / 255f, 1}, within(0.02f));
    }

    /** The formula of TIFF 6.0, section 21, with the luminance of CCIR 601-1. */
    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void luminanceAndChrominanceAreConverted(int bits) throws IOException {
        double largest = (1 << bits) - 1;
        double half = 1 << bits - 1;
        TiffSample.Codes codes = (x, y, s) -> (long) (half + (s == 0 ? 0.05 * x : s == 1 ? 0.1 : -0.05) * half);
        for (ByteOrder order : ORDERS) {
            byte[] file = new TiffSample(WIDTH, HEIGHT, 6, TiffSample.bits(3, bits), codes)
                    .order(order)
                    .tag(530, 1, 1)
                    .bytes();
            Pixels pixels = TiffReader.read(file, "p.tif");
            for (int x = 0; x < WIDTH; x++) {
                double luminance = codes.at(x, 0, 0);
                double red = luminance + 1.402 * (codes.at(x, 0, 2) - half);
                double blue = luminance + 1.772 * (codes.at(x, 0, 1) - half);
                double green = (luminance - 0.299 * red - 0.114 * blue) / 0.587;
                assertThat(Arrays.copyOfRange(pixels.rgba(), 4 * x, 4 * x + 4))
                        .containsExactly(
                                new float[] {
                                    (float) (red / largest), (float) (green / largest), (float) (blue / largest), 1
                                },
                                within(0.006f));
            }
        }
    }

    @Test
    void greyJpegInsideMayBeWhiteIsZero() throws IOException {
        BufferedImage image = new BufferedImage(16, 16, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < 256; i++) {
            image.getRaster().setSample(i % 16, i / 16, 0, 51);
        }
        byte[] file = Samples.compressedTiff(image, "JPEG");
        assertThat(TiffReader.read(file, "p.tif").rgba()).startsWith(0.2f, 0.2f, 0.2f, 1);
        ByteBuffer tags = ByteBuffer.wrap(file).order(file[0] == 'I' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        int at = tags.getInt(4) + 2;
        while (tags.getShort(at) != 262) {
            at += 12;
        }
        tags.putShort(at + 8, (short) 0);
        assertThat(TiffReader.read(file, "p.tif").rgba()).startsWith(0.8f, 0.8f, 0.8f, 1);
    }

    /** Whatever JPEG packs means what the tags say: colours, opacity that is associated or not, and other samples. */
    @ParameterizedTest
    @CsvSource({"0", "1", "2"})
    void jpegInsideHoldsAnySamples(int extra) throws IOException {
        TiffSample.Codes codes = (x, y, s) -> s == 3 ? 128 : 20 * s + 3 * x + 2 * y;
        Expected expected = (x, y) -> {
            float[] pixel = new float[4];
            for (int s = 0; s < 3; s++) {
                pixel[s] = codes.at(x, y, s) / (extra == 1 ? 128f : 255f);
            }
            pixel[3] = extra == 0 ? 1 : 128 / 255f;
            return pixel;
        };
        for (TiffSample sample : jpegs(2, 4, codes)) {
            assertPixels(sample.tag(338, extra).bytes(), expected, 0.015f);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 6})
    void jpegInsideHasTheColoursOfTheTags(int photometric) throws IOException {
        TiffSample.Codes codes = (x, y, s) -> s == 0 ? 60 + 5 * x : 110 + 3 * y + 6 * s;
        Expected expected = (x, y) -> {
            float luminance = codes.at(x, y, 0);
            float blue = codes.at(x, y, 1) - 128;
            float red = codes.at(x, y, 2) - 128;
            float[] levels = switch (photometric) {
                case 0 -> new float[] {255 - luminance, 255 - luminance, 255 - luminance, 255};
                case 1 -> new float[] {luminance, luminance, luminance, 255};
                case 2 -> new float[] {luminance, blue + 128, red + 128, 255};
                default ->
                    new float[] {
                        luminance + 1.402f * red,
                        luminance - 0.344136f * blue - 0.714136f * red,
                        luminance + 1.772f * blue,
                        255
                    };
            };
            for (int i = 0; i < 4; i++) {
                levels[i] /= 255;
            }
            return levels;
        };
        for (TiffSample sample : jpegs(photometric, photometric < 2 ? 1 : 3, codes)) {
            assertPixels(sample.tag(530, 1, 1).bytes(), expected, 0.02f);
        }
    }

    private static List<TiffSample> jpegs(int photometric, int samples, TiffSample.Codes codes) {
        return Stream.of(
                        new TiffSample(WIDTH, HEIGHT, photometric, TiffSample.bits(samples, 8), codes),
                        new TiffSample(WIDTH, HEIGHT, photometric, TiffSample.bits(samples, 8), codes).strips(3),
                        new TiffSample(WIDTH, HEIGHT, photometric, TiffSample.bits(samples, 8), codes).tiles(16, 16),
                        new TiffSample(WIDTH, HEIGHT, photometric, TiffSample.bits(samples, 8), codes).tiles(8, 4),
                        new TiffSample(WIDTH, HEIGHT, photometric, TiffSample.bits(samples, 8), codes)
                                .planar()
                                .strips(4))
                .map(sample -> sample.compression(TiffSample.JPEG, 1))
                .toList();
    }

    /**
     * Blocks of pixels that share their chrominance: in the file they are one pixel of many samples, of which the last
     * two are the chrominance.
     */
    @ParameterizedTest
    @CsvSource({"1, 1", "2, 1", "1, 2", "2, 2", "4, 1", "4, 2", "4, 4"})
    void pixelsMayShareTheirChrominance(int across, int down) throws IOException {
        TiffSample.Codes luminance = (x, y, s) -> 50 + 9 * x + 4 * y;
        TiffSample.Codes blocks = (x, y, s) -> s >= across * down
                ? 120 + 3 * x + 3 * y - 5 * (s - across * down)
                : luminance.at(x * across + s % across, y * down + s / across, 0);
        int columns = (WIDTH + across - 1) / across;
        int rows = (HEIGHT + down - 1) / down;
        int[] bits = TiffSample.bits(across * down + 2, 8);
        Expected expected = (x, y) -> {
            float level = luminance.at(x, y, 0);
            float blue = blocks.at(x / across, y / down, across * down) - 128;
            float red = blocks.at(x / across, y / down, across * down + 1) - 128;
            return new float[] {
                (level + 1.5748f * red) / 255,
                (level - 0.187324f * blue - 0.468124f * red) / 255,
                (level + 1.8556f * blue) / 255,
                1
            };
        };
        for (ByteOrder order : ORDERS) {
            for (TiffSample sample : List.of(
                    new TiffSample(columns, rows, 6, bits, blocks),
                    new TiffSample(columns, rows, 6, bits, blocks).compression(TiffSample.LZW, 1),
                    new TiffSample(columns, rows, 6, bits, blocks).strips(1).tag(278, down),
                    new TiffSample(columns, rows, 6, bits, blocks)
                            .tiles(2, 1)
                            .tag(322, 2 * across)
                            .tag(323, down))) {
                byte[] file = sample.order(order)
                        .tag(256, WIDTH)
                        .tag(257, HEIGHT)
                        .tag(258, 8, 8, 8)
                        .tag(277, 3)
                        .tag(530, across, down)
                        .shares(2126, 7152, 722)
                        .bytes();
                assertPixels(file, expected, 0.001f);
            }
        }
    }

    /** Luminance from 16 to 235, chrominance from 16 to 240, as in video. */
    @Test
    void blackAndWhiteMayHaveOtherNumbers() throws IOException {
        TiffSample.Codes codes = (x, y, s) -> s == 0 ? 16 + 219 * y / 6 : s == 1 ? 128 : 240;
        byte[] file = new TiffSample(WIDTH, HEIGHT, 6, TiffSample.bits(3, 8), codes)
                .tag(530, 1, 1)
                .tag(532, 16, 235, 128, 240, 128, 240)
                .bytes();
        assertPixels(
                file,
                (x, y) -> {
                    float level = (219 * y / 6) / 219f;
                    float red = 127 / 255f;
                    return new float[] {
                        Math.min(1, level + 1.402f * red), Math.max(0, level - 0.714136f * red), level, 1
                    };
                },
                0.0001f);
    }

    /** The predictor counts only for compressions that have one. */
    @ParameterizedTest
    @CsvSource({"1", "32773"})
    void aPredictorOfOtherCompressionsSaysNothing(int compression) throws IOException {
        TiffSample.Codes codes = levels(8);
        byte[] file = new TiffSample(WIDTH, HEIGHT, 1, new int[] {8}, codes)
                .compression(compression, 1)
                .tag(317, 2)
                .bytes();
        assertPixels(file, (x, y) -> {
            float level = codes.at(x, y, 0) / 255f;
            return new float[] {level, level, level, 1};
        });
    }

    /** A strip of its own for each row, as scanners write them: each is handed to the library. */
    @Test
    void manyPackedStripsTakeLittleTime() throws IOException {
        byte[] file = new TiffSample(8, 5_000, 1, new int[] {8}, (x, y, s) -> x)
                .strips(1)
                .compression(TiffSample.PACK_BITS, 1)
                .bytes();
        Pixels pixels = assertTimeout(Duration.ofSeconds(20), () -> TiffReader.read(file, "p.tif"));
        assertThat(pixels.height()).isEqualTo(5_000);
    }

    @Test
    void aBigTiffIsRead() throws IOException {
        ByteBuffer file = ByteBuffer.allocate(300).order(ByteOrder.LITTLE_ENDIAN);
        long[][] tags = {{256, 2}, {257, 1}, {258, 12}, {259, 1}, {262, 1}, {273, 200}, {277, 1}, {278, 1}, {279, 3}};
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
        file.putLong(0).position(200).put((byte) 0xff).put((byte) 0xf8).put((byte) 0);
        assertThat(TiffReader.read(file.array(), "p.tif").rgba())
                .containsExactly(new float[] {1, 1, 1, 1, 2048 / 4095f, 2048 / 4095f, 2048 / 4095f, 1}, within(1e-7f));
    }
}
