package tompkins.image;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RadianceFileTest {

    private static byte[] write(int width, int height, float[] rgb) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        RadianceFile.write(out, new LinearImage(width, height, rgb), PhotographInfo.NONE);
        return out.toByteArray();
    }

    /** The code of one pixel: a picture one pixel wide is not packed, so its last four bytes are the pixel. */
    private static int[] code(float red, float green, float blue) throws IOException {
        byte[] file = write(1, 1, new float[] {red, green, blue});
        int[] code = new int[4];
        for (int i = 0; i < 4; i++) {
            code[i] = file[file.length - 4 + i] & 0xff;
        }
        return code;
    }

    /** Worked by hand: 1 = 1/2 * 2^1, so e = 1 and the mantissas are light * 128. */
    @ParameterizedTest
    @CsvSource({
        "1, 0.5, 0.25, 128, 64, 32, 129",
        "0.999, 0, 0, 255, 0, 0, 128",
        "10, 20, 30, 80, 160, 240, 133",
        "0.00390625, 0, 0.001, 128, 0, 32, 121",
        "0, 0, 0, 0, 0, 0, 0",
        "-1, -2, -3, 0, 0, 0, 0",
        "NaN, 1, NaN, 0, 128, 0, 129",
        "Infinity, 1e38, 0, 255, 150, 0, 255",
        "1e-39, 0, 0, 0, 0, 0, 0"
    })
    void pixelsHaveTheCodesOfTheDefinition(float red, float green, float blue, int r, int g, int b, int e)
            throws IOException {
        assertThat(code(red, green, blue)).containsExactly(r, g, b, e);
    }

    /** 2^(e-1) is at most the brightest channel, 2^e is above it, a mantissa is the whole part of 256 light / 2^e. */
    @Test
    void randomPixelsHaveTheCodesOfTheDefinition() throws IOException {
        Random random = new Random(7);
        for (int i = 0; i < 500; i++) {
            float[] light = new float[3];
            for (int channel = 0; channel < 3; channel++) {
                light[channel] = (float) (random.nextDouble() * Math.pow(10, random.nextInt(40) - 20));
            }
            BigDecimal brightest = new BigDecimal(Math.max(light[0], Math.max(light[1], light[2])));
            int exponent = -127;
            while (brightest.compareTo(power(exponent)) >= 0) {
                exponent++;
            }
            int[] expected = new int[4];
            for (int channel = 0; channel < 3; channel++) {
                expected[channel] = new BigDecimal(light[channel])
                        .multiply(power(8 - exponent))
                        .setScale(0, RoundingMode.DOWN)
                        .intValueExact();
            }
            expected[3] = exponent + 128;
            assertThat(code(light[0], light[1], light[2])).containsExactly(expected);
        }
    }

    private static BigDecimal power(int exponent) {
        BigDecimal two = BigDecimal.valueOf(2);
        return exponent >= 0 ? two.pow(exponent) : BigDecimal.ONE.divide(two.pow(-exponent));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 7, 8, 9, 127, 128, 129, 255, 256, 640, 32767, 32768})
    void rowsUnpackToTheirPixels(int width) throws IOException {
        Random random = new Random(width);
        float[] rgb = new float[3 * width * 2];
        float level = 0;
        for (int i = 0; i < rgb.length; i++) {
            // Runs of all lengths, and stretches without.
            if (random.nextInt(8) == 0 || i / 3 % 300 < 100 && random.nextBoolean()) {
                level = random.nextInt(256) / 64f;
            }
            rgb[i] = i / 3 % width > width / 2 ? 0.75f : level;
        }

        byte[] file = write(width, 2, rgb);

        String header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X " + width + "\n";
        assertThat(new String(file, 0, header.length(), ISO_8859_1)).isEqualTo(header);
        // multiples of 1/64 below 4 lose nothing
        float[] read = RadianceReader.read(file, "p.hdr").rgba();
        for (int i = 0; i < rgb.length; i++) {
            assertThat(read[i / 3 * 4 + i % 3]).as("value %d", i).isEqualTo(rgb[i]);
        }
    }

    @Test
    void evenRowsArePackedSmall() throws IOException {
        assertThat(write(1270, 1, new float[3 * 1270])).hasSizeLessThan(150);
    }

    @Test
    void headerLinesAreShortAndAscii() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        String scene = "{\"β\": \"" + "long ".repeat(100) + "\"}\r\n\r{\n";
        RadianceFile.write(out, Samples.random(8, 1, 1), new PhotographInfo("γ", "Tompkins", scene));

        String header = out.toString(ISO_8859_1).split("\n\n")[0];
        assertThat(header.lines())
                .allSatisfy(line -> assertThat(line).matches("\\p{ASCII}{1,230}"))
                .startsWith("#?RADIANCE", "# \\u03b3", "SOFTWARE=Tompkins")
                .endsWith("FORMAT=32-bit_rle_rgbe");
        assertThat(RadianceFile.readScene(out.toByteArray()))
                .contains(scene.replace("\r\n", "\n").replace('\r', '\n'));
    }
}
