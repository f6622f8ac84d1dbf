package tompkins.image;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.file.FileException;

class RadianceReaderTest {

    private enum Packing {
        FLAT,
        NEW_RUNS
    }

    private static final String FORMAT = "FORMAT=32-bit_rle_rgbe\n";

    /** The code of light (1, 1/2, 1/4) times 2^n; runs of equal pixels, and pixels alone. */
    private static byte[] code(int column, int row) {
        int exponent = 129 + (column > 4 && column < 400 ? 0 : column % 7) + row;
        return new byte[] {(byte) 128, 64, 32, (byte) exponent};
    }

    private static byte[] file(String header, String resolution, int columns, int rows, Packing packing) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(("#?RADIANCE\n" + header + "\n" + resolution + "\n").getBytes(ISO_8859_1));
        for (int row = 0; row < rows; row++) {
            switch (packing) {
                case FLAT -> {
                    for (int column = 0; column < columns; column++) {
                        out.writeBytes(code(column, row));
                    }
                }
                case NEW_RUNS -> writePlanes(out, columns, row);
            }
        }
        return out.toByteArray();
    }

    private static void writePlanes(ByteArrayOutputStream out, int columns, int row) {
        out.writeBytes(new byte[] {2, 2, (byte) (columns >> 8), (byte) columns});
        for (int channel = 0; channel < 4; channel++) {
            for (int column = 0; column < columns; ) {
                int end = column + 1;
                while (end < columns && end - column < 127 && code(end, row)[channel] == code(column, row)[channel]) {
                    end++;
                }
                if (end - column > 2) {
                    out.write(128 + end - column);
                    out.write(code(column, row)[channel]);
                } else {
                    out.write(end - column);
                    for (int i = column; i < end; i++) {
                        out.write(code(i, row)[channel]);
                    }
                }
                column = end;
            }
        }
    }

    private static double light(int column, int row) {
        return Math.scalb(1.0, code(column, row)[3] + 256 - 129);
    }

    @ParameterizedTest
    @EnumSource
    void rowsAreReadHoweverTheyArePacked(Packing packing) throws IOException {
        int[] widths = packing == Packing.NEW_RUNS
                ? new int[] {8, 9, 127, 128, 640, 32767}
                : new int[] {1, 5, 7, 8, 9, 640, 32768, 70001};
        for (int width : widths) {
            byte[] file = file(FORMAT, "-Y 3 +X " + width, width, 3, packing);
            Pixels pixels = RadianceReader.read(file, "p.hdr");
            assertThat(new int[] {pixels.width(), pixels.height()}).containsExactly(width, 3);
            for (int y = 0; y < 3; y++) {
                for (int x = 0; x < width; x++) {
                    assertPixel(pixels, x, y, light(x, y), light(x, y) / 2, light(x, y) / 4);
                }
            }
        }
    }

    private static void assertPixel(Pixels pixels, int x, int y, double red, double green, double blue) {
        int at = 4 * (y * pixels.width() + x);
        float[] found = Arrays.copyOfRange(pixels.rgba(), at, at + 4);
        float[] expected = {(float) red, (float) green, (float) blue, 1};
        if (!Arrays.equals(found, expected)) {
            assertThat(found).as("pixel %d, %d", x, y).containsExactly(expected, within(1e-6f));
        }
    }

    /** Where the first pixel of the file lies, and the second: the signs tell whether an axis goes up or down. */
    @ParameterizedTest
    @CsvSource({
        "-Y 2 +X 3, 3, 0, 0, 1, 0",
        "-Y 2 -X 3, 3, 2, 0, 1, 0",
        "+Y 2 -X 3, 3, 2, 1, 1, 1",
        "+Y 2 +X 3, 3, 0, 1, 1, 1",
        "+X 2 -Y 3, 2, 0, 0, 0, 1",
        "-X 2 -Y 3, 2, 1, 0, 1, 1",
        "-X 2 +Y 3, 2, 1, 2, 1, 1",
        "+X 2 +Y 3, 2, 0, 2, 0, 1"
    })
    void theAxesMayRunAsTheyWill(String resolution, int width, int x, int y, int secondX, int secondY)
            throws IOException {
        Pixels pixels = RadianceReader.read(file(FORMAT, resolution, 3, 2, Packing.FLAT), "p.hdr");

        assertThat(pixels.width()).isEqualTo(width);
        assertThat(pixels.height()).isEqualTo(5 - width);
        assertPixel(pixels, x, y, 1, 0.5, 0.25);
        assertPixel(pixels, secondX, secondY, 2, 1, 0.5);
    }

    /** All factors of the header together, whatever else stands there. */
    @ParameterizedTest
    @CsvSource({
        "'', 1, 0.5, 0.25",
        "EXPOSURE=4, 0.25, 0.125, 0.0625",
        "EXPOSURE= 4.0e+00 , 0.25, 0.125, 0.0625",
        "EXPOSURE=4|EXPOSURE=0.5, 0.5, 0.25, 0.125",
        "COLORCORR=2 1 0.5, 0.5, 0.5, 0.5",
        "COLORCORR= 2.0 1.0 0.5|EXPOSURE=2|COLORCORR=2 2 2, 0.125, 0.125, 0.125",
        "'\tEXPOSURE=4', 1, 0.5, 0.25",
        "GAMMA=2.2|PRIMARIES=0.64 0.33 0.29 0.6 0.15 0.06 0.3333 0.3333|PIXASPECT=2|VIEW=-vtv|# EXPOSURE=3, 1, 0.5, 0.25"
    })
    void lightIsThatBeforeTheExposure(String lines, double red, double green, double blue) throws IOException {
        String header = lines.isEmpty() ? "" : lines.replace('|', '\n') + "\n";
        for (String format : new String[] {FORMAT, ""}) {
            Pixels pixels = RadianceReader.read(file(format + header, "-Y 1 +X 1", 1, 1, Packing.FLAT), "p.hdr");
            assertPixel(pixels, 0, 0, red, green, blue);
        }
    }

    @Test
    void anExponentOfZeroIsBlack() throws IOException {
        byte[] file = file(FORMAT, "-Y 1 +X 1", 1, 1, Packing.FLAT);
        file[file.length - 1] = 0;
        assertPixel(RadianceReader.read(file, "p.hdr"), 0, 0, 0, 0, 0);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "FORMAT=32-bit_rle_xyze| -Y 1 +X 1| its colours are CIE XYZ (32-bit_rle_xyze), not red, green and blue (32-bit_rle_rgbe); save it as RGB",
                "FORMAT=16-bit| -Y 1 +X 1| the format of a Radiance picture must be 32-bit_rle_rgbe, was 16-bit",
                "EXPOSURE=0| -Y 1 +X 1| EXPOSURE of a Radiance picture must be a number above 0, was 0",
                "EXPOSURE=bright| -Y 1 +X 1| EXPOSURE of a Radiance picture must be a number above 0, was bright",
                "EXPOSURE=NaN| -Y 1 +X 1| EXPOSURE of a Radiance picture must be a number above 0, was NaN",
                "EXPOSURE=0x1p3| -Y 1 +X 1| EXPOSURE of a Radiance picture must be a number above 0, was 0x1p3",
                "EXPOSURE=1e-300| -Y 1 +X 1| pixel (0, 0) has a value of Infinity; those of a picture must be finite",
                "COLORCORR=1 2| -Y 1 +X 1| COLORCORR of a Radiance picture must be 3 numbers above 0, was 1 2",
                "VIEW=| -Y 1 -Y 1| the size of a Radiance picture must be such as -Y 480 +X 640, was -Y 1 -Y 1",
                "VIEW=| 1 x 1| the size of a Radiance picture must be such as -Y 480 +X 640, was 1 x 1",
                "VIEW=| -Y 0 +X 1| claims to have 1 x 0 pixels; a picture may have from 1 to 64000000"
            })
    void whatIsNotReadIsNamed(String line, String resolution, String reason) {
        assertThatThrownBy(() -> PictureFile.read(file(line + "\n", resolution, 1, 1, Packing.FLAT), "p.hdr"))
                .isInstanceOf(FileException.class)
                .hasMessage("p.hdr: " + reason);
    }

    @ParameterizedTest
    @CsvSource({"1e300, Infinity", "1e-300, 0.0"})
    void exposuresTogetherMustBeANumber(String exposure, String product) {
        String header = ("EXPOSURE=" + exposure + "\n").repeat(2);
        assertThatThrownBy(() -> PictureFile.read(file(header, "-Y 1 +X 1", 1, 1, Packing.FLAT), "p.hdr"))
                .hasMessage(
                        "p.hdr: the exposures of a Radiance picture must have a product above 0 that is finite, was "
                                + product);
    }

    @Test
    void whatAHeaderSaysIsNoCodeForATerminal() {
        byte[] file = file("FORMAT=\u001b[31m" + "x".repeat(100) + "\n", "-Y 1 +X 1", 1, 1, Packing.FLAT);
        assertThatThrownBy(() -> PictureFile.read(file, "p.hdr"))
                .hasMessage("p.hdr: the format of a Radiance picture must be 32-bit_rle_rgbe, was ?[31m"
                        + "x".repeat(35) + "...");
    }

    /** A run beyond its row, a run of nothing, a row of another length. */
    @ParameterizedTest
    @ValueSource(strings = {"2 2 0 8 137 1", "2 2 0 8 9 1 1 1 1 1 1 1 1 1", "2 2 0 9 137 1"})
    void aRunThatDoesNotFitIsDamage(String bytes) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(file(FORMAT, "-Y 1 +X 8", 0, 0, Packing.FLAT));
        for (String value : bytes.split(" ")) {
            out.write(Integer.parseInt(value));
        }
        out.writeBytes(new byte[100]);
        assertThatThrownBy(() -> PictureFile.read(out.toByteArray(), "p.hdr"))
                .isInstanceOf(FileException.class)
                .hasMessageStartingWith("p.hdr: Radiance picture cannot be read: a r");
    }

    /** A pixel, and how often it comes again: as pixels these bytes would be no light. */
    @Test
    void runsOfWholePixelsAreRefused() {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(file(FORMAT, "-Y 1 +X 9", 0, 0, Packing.FLAT));
        out.writeBytes(new byte[] {(byte) 128, 64, 32, (byte) 129, 1, 1, 1, 8});
        out.writeBytes(new byte[28]);
        assertThatThrownBy(() -> PictureFile.read(out.toByteArray(), "p.hdr"))
                .hasMessage("p.hdr: has runs of whole pixels; a Radiance picture must have runs in each channel, or"
                        + " none; convert it, for example with ImageMagick or GIMP");
    }
}
