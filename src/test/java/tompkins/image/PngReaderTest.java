package tompkins.image;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PngReaderTest {

    private static final int WIDTH = 5;
    private static final int PALETTE = 3;

    private static void chunk(ByteArrayOutputStream out, String type, byte[] data) {
        ByteBuffer chunk = ByteBuffer.allocate(data.length + 12).putInt(data.length);
        chunk.put(type.getBytes(ISO_8859_1)).put(data);
        CRC32 sum = new CRC32();
        sum.update(chunk.array(), 4, data.length + 4);
        out.writeBytes(chunk.putInt((int) sum.getValue()).array());
    }

    /** A picture of one row; further chunks come before its pixels. */
    private static byte[] png(int bits, int colourType, int[] samples, Object... further) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
        int channels = colourType == 2 ? 3 : colourType == 6 ? 4 : colourType == 4 ? 2 : 1;
        byte[] header = {(byte) bits, (byte) colourType, 0, 0, 0};
        chunk(
                out,
                "IHDR",
                ByteBuffer.allocate(13)
                        .putInt(samples.length / channels)
                        .putInt(1)
                        .put(header)
                        .array());
        for (int i = 0; i < further.length; i += 2) {
            chunk(out, (String) further[i], (byte[]) further[i + 1]);
        }
        StringBuilder row = new StringBuilder("00000000");
        for (int sample : samples) {
            for (int bit = bits - 1; bit >= 0; bit--) {
                row.append(sample >> bit & 1);
            }
        }
        row.append("0".repeat((8 - row.length() % 8) % 8));
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(packed)) {
            for (int i = 0; i < row.length(); i += 8) {
                deflater.write(Integer.parseInt(row.substring(i, i + 8), 2));
            }
        }
        chunk(out, "IDAT", packed.toByteArray());
        chunk(out, "IEND", new byte[0]);
        return out.toByteArray();
    }

    private static byte[] shorts(int... numbers) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * numbers.length);
        for (int number : numbers) {
            bytes.putShort((short) number);
        }
        return bytes.array();
    }

    /** The level that is transparent is so, and its neighbours are not. */
    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void aLevelOfGreyMayBeTransparent(int bits) throws IOException {
        int largest = (1 << bits) - 1;
        int[] levels = {0, 1, largest, Math.min(2, largest), largest - 1};
        for (int transparent : levels) {
            // The upper bits of the two bytes say nothing.
            int written = transparent | (bits < 16 ? 0xff00 << bits & 0x8000 : 0);
            byte[] file = png(bits, 0, levels, "tRNS", shorts(written));
            float[] rgba = PngReader.read(file, "p.png").rgba();
            for (int x = 0; x < WIDTH; x++) {
                float level = levels[x] / (float) largest;
                assertThat(java.util.Arrays.copyOfRange(rgba, 4 * x, 4 * x + 4))
                        .as("level %d of %d, transparent is %d", levels[x], largest, transparent)
                        .containsExactly(level, level, level, levels[x] == transparent ? 0 : 1);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void aLevelOfFewBitsMayNotBeTransparent(int bits) throws IOException {
        byte[] file = png(bits, 0, new int[] {0, 1}, "tRNS", shorts(1));
        assertThatThrownBy(() -> PictureFile.read(file, "p.png"))
                .hasMessage("p.png: has a transparent level of " + bits + " bits; a PNG picture must have one of 8 or"
                        + " 16 bits; convert it, for example with ImageMagick or GIMP");
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void aColourMayBeTransparent(int bits) throws IOException {
        int largest = (1 << bits) - 1;
        int[] samples = {10, 20, 30, 10, 20, 31, 0, 0, 0, largest, 20, 30};
        Pixels pixels = PngReader.read(png(bits, 2, samples, "tRNS", shorts(10, 20, 30)), "p.png");
        for (int x = 0; x < 4; x++) {
            assertThat(pixels.rgba()[4 * x]).isEqualTo(samples[3 * x] / (float) largest);
            assertThat(pixels.rgba()[4 * x + 3]).isEqualTo(x == 0 ? 0 : 1);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 8})
    void coloursOfAPaletteMayBeTransparent(int bits) throws IOException {
        byte[] palette = {(byte) 255, 0, 0, 0, 51, 102};
        byte[] opacity = {0, 51};
        Pixels pixels = PngReader.read(png(bits, 3, new int[] {1, 0, 1}, "PLTE", palette, "tRNS", opacity), "p.png");
        assertThat(pixels.rgba()).containsExactly(0, 0.2f, 0.4f, 0.2f, 1, 0, 0, 0, 0, 0.2f, 0.4f, 0.2f);
        float[] opaque = PngReader.read(png(bits, 3, new int[] {1, 0}, "PLTE", palette), "p.png")
                .rgba();
        assertThat(opaque).containsExactly(0, 0.2f, 0.4f, 1, 1, 0, 0, 1);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 4, 8})
    void aColourThatThePaletteHasNotIsDamage(int bits) throws IOException {
        byte[] palette = {(byte) 255, 0, 0, 0, 51, 102};
        byte[] picture = png(bits, 3, new int[] {1, 2, 0}, "PLTE", palette);
        assertThatThrownBy(() -> PngReader.read(picture, "p.png")).hasMessage("a pixel's colour is not in the palette");
    }

    @ParameterizedTest
    @CsvSource({"8, 4", "16, 4", "8, 6", "16, 6"})
    void opacityIsRead(int bits, int colourType) throws IOException {
        int largest = (1 << bits) - 1;
        int[] samples = colourType == 4
                ? new int[] {largest / 3, largest / 5}
                : new int[] {0, largest / 3, largest, largest / 5};
        float[] rgba = PngReader.read(png(bits, colourType, samples), "p.png").rgba();
        float level = 1 / 3f;
        assertThat(rgba)
                .containsExactly(
                        colourType == 4 ? new float[] {level, level, level, 0.2f} : new float[] {0, level, 1, 0.2f});
    }

    /** Profiles, gamma and significant bits change no number, not even when they are damaged. */
    @Test
    void numbersAreTakenAsTheyAre() throws IOException {
        int[] samples = {128, 64, 32};
        byte[] gamma = {0, 0, (byte) 0xb1, (byte) 0x8f};
        for (Object[] chunks : new Object[][] {
            {},
            {"gAMA", gamma},
            {"sRGB", new byte[1]},
            {"iCCP", "damaged\0\0no profile".getBytes(ISO_8859_1)},
            {"cHRM", new byte[32], "gAMA", gamma, "sBIT", new byte[] {5, 6, 5}, "zTXt", new byte[3]},
            {"PLTE", new byte[3], "tIME", new byte[1]}
        }) {
            float[] rgba = PngReader.read(png(8, 2, samples, chunks), "p.png").rgba();
            assertThat(rgba).containsExactly(128 / 255f, 64 / 255f, 32 / 255f, 1);
        }
    }

    @Test
    void exifTurnsThePicture() throws IOException {
        Pixels turned = PngReader.read(png(8, 0, new int[] {255, 0, 51}, "eXIf", exif(6)), "p.png");
        assertThat(new int[] {turned.width(), turned.height()}).containsExactly(1, 3);
        assertThat(turned.rgba()[0]).isEqualTo(1);
        assertThat(turned.rgba()[8]).isEqualTo(0.2f);
        byte[] damaged = new byte[20];
        assertThat(PngReader.read(png(8, 0, new int[] {255, 0}, "eXIf", damaged), "p.png")
                        .width())
                .isEqualTo(2);
    }

    /** A TIFF header and one tag. */
    static byte[] exif(int orientation) {
        ByteBuffer exif = ByteBuffer.allocate(26).putInt(0x4d4d002a).putInt(8).putShort((short) 1);
        exif.putShort((short) 274).putShort((short) 3).putInt(1).putShort((short) orientation);
        return exif.array();
    }

    /** What lies behind the last chunk belongs to no picture, even if it looks like chunks. */
    @Test
    void whatFollowsTheEndSaysNothing() throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.writeBytes(png(8, 0, new int[] {255, 0, 51}));
        chunk(file, "eXIf", exif(6));
        chunk(file, "tRNS", shorts(255));
        chunk(file, "CgBI", new byte[4]);
        Pixels pixels = PngReader.read(file.toByteArray(), "p.png");
        assertThat(pixels.width()).isEqualTo(3);
        assertThat(Arrays.copyOf(pixels.rgba(), 5)).containsExactly(1, 1, 1, 1, 0);
    }

    /** A byte that changed, in a part that says what the pixels are or in any other. */
    @ParameterizedTest
    @CsvSource({"0, IHDR", "3, PLTE", "3, tRNS", "0, tRNS", "0, IDAT", "0, tEXt"})
    void aDamagedPartIsNamed(int colourType, String part) throws IOException {
        byte[] palette = {0, 0, 0, 9, 9, 9};
        byte[] file = colourType == PALETTE
                ? png(8, colourType, new int[] {1, 0}, "PLTE", palette, "tRNS", shorts(1))
                : png(8, colourType, new int[] {1, 0}, "tEXt", new byte[4], "tRNS", shorts(1));
        int at = new String(file, ISO_8859_1).indexOf(part);
        // The check sum, after length and name.
        file[at + 4 + ByteBuffer.wrap(file).getInt(at - 4)] ^= 1;
        assertThatThrownBy(() -> PictureFile.read(file, "p.png"))
                .hasMessage("p.png: PNG picture cannot be read: the file is damaged in the part that begins at byte "
                        + (at - 4) + "; another copy of it may be intact");
    }

    @Test
    void aHeaderThatIsNotTheFirstChunkIsTheReason() throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.writeBytes(PngChunk.SIGNATURE);
        chunk(file, "tEXt", new byte[] {'a', 0, 'b'});
        chunk(file, "IHDR", new byte[] {0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0});
        assertThatThrownBy(() -> PictureFile.read(file.toByteArray(), "p.png"))
                .hasMessageStartingWith("p.png: begins with tEXt; a PNG picture must begin with its header (IHDR); ");
    }

    @Test
    void aFormOfAppleIsNamed() throws IOException {
        byte[] file = png(8, 0, new int[] {1});
        byte[] apple = new byte[file.length + 16];
        System.arraycopy(file, 0, apple, 0, 8);
        ByteArrayOutputStream first = new ByteArrayOutputStream();
        chunk(first, "CgBI", new byte[4]);
        System.arraycopy(first.toByteArray(), 0, apple, 8, 16);
        System.arraycopy(file, 8, apple, 24, file.length - 8);
        assertThatThrownBy(() -> PictureFile.read(apple, "p.png"))
                .hasMessage(
                        "p.png: begins with what only Apple devices read (CgBI); a PNG picture must begin with its header (IHDR)"
                                + "; convert it, for example with ImageMagick or GIMP");
    }
}
