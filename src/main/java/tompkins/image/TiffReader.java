package tompkins.image;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.awt.image.Raster;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import tompkins.file.FileException;

/**
 * Reads the first picture of TIFF files (TIFF 6.0, BigTIFF) with the library. Its tags must be those of a kind that is
 * known to come out right; every other is refused with its name.
 */
final class TiffReader {

    private static final int WHITE_IS_ZERO = 0;
    private static final int BLACK_IS_ZERO = 1;
    private static final int RGB = 2;
    private static final int PALETTE = 3;

    private static final long NOT_PACKED = 1;
    private static final long PACK_BITS = 32773;

    private static final int UNSIGNED = 1;
    private static final int SIGNED = 2;
    private static final int FLOATING = 3;
    private static final int UNDEFINED = 4;
    private static final int ASSOCIATED = 1;
    private static final int UNASSOCIATED = 2;

    private static final float LARGEST_BYTE = 255;
    private static final float LARGEST_OF_PALETTE = 65535;

    private static final Map<Long, String> PACKINGS = Map.ofEntries(
            Map.entry(2L, "fax"),
            Map.entry(3L, "fax"),
            Map.entry(4L, "fax"),
            Map.entry(6L, "JPEG of the old kind"),
            Map.entry(7L, "JPEG"),
            Map.entry(34676L, "SGI LogLuv"),
            Map.entry(34712L, "JPEG 2000"),
            Map.entry(34887L, "LERC"),
            Map.entry(34925L, "LZMA"),
            Map.entry(50000L, "Zstandard"),
            Map.entry(50001L, "WebP"),
            Map.entry(50002L, "JPEG XL"));

    private static final Map<Long, String> COLOURS = Map.of(
            4L, "a mask for another picture",
            5L, "inks, as cyan, magenta, yellow and black",
            6L, "luminance and chrominance, YCbCr",
            8L, "CIE L*a*b*",
            32803L, "raw numbers of a camera",
            32844L, "logarithms, SGI LogLuv",
            32845L, "logarithms, SGI LogLuv",
            34892L, "raw numbers of a camera");

    private final TiffDirectory tags;
    private final String name;
    private final long colours;
    private final long samples;

    /** The kind of opacity, 0 for none. */
    private final long opacity;

    /**
     * Reads the tags.
     *
     * @throws FileException if they are not of a kind that is read
     */
    private TiffReader(TiffDirectory tags, String name) throws IOException {
        this.tags = tags;
        this.name = name;
        colours = tags.number(TIFF.TAG_PHOTOMETRIC_INTERPRETATION, -1);
        samples = tags.number(TIFF.TAG_SAMPLES_PER_PIXEL, 1);
        long[] further = tags.numbers(TIFF.TAG_EXTRA_SAMPLES);
        opacity = further.length > 0 ? further[0] : 0;
        requirePacking();
        requireColours();
        requireNumbers();
    }

    /**
     * Refuses a picture of a kind that is not read.
     *
     * @throws FileException if it is one
     */
    static void requireReadable(TiffDirectory tags, String name) throws IOException {
        new TiffReader(tags, name);
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        TiffDirectory tags = TiffDirectory.read(file);
        Pixels.requireSize(tags.number(TIFF.TAG_IMAGE_WIDTH, 0), tags.number(TIFF.TAG_IMAGE_HEIGHT, 0), name);
        return new TiffReader(tags, name).pixels(LibraryReader.samples(PictureEncoding.TIFF, file, name));
    }

    private void requirePacking() throws IOException {
        long compression = tags.number(TIFF.TAG_COMPRESSION, NOT_PACKED);
        require(
                List.of(NOT_PACKED, 5L, 8L, PACK_BITS, 32946L).contains(compression),
                "its compression is " + named(PACKINGS, compression),
                "have none, LZW, Deflate or PackBits");
        require(
                compression != PACK_BITS || tags.number(TIFF.TAG_PREDICTOR, 1) == 1,
                "has a predictor and PackBits",
                "have a predictor with LZW or Deflate alone");
    }

    private void requireColours() throws IOException {
        require(colours >= 0, "does not say what its colours are", "have a photometric interpretation");
        require(
                colours <= PALETTE,
                "its colours are " + named(COLOURS, colours),
                "be grey, red, green and blue, or of a palette");
        int needed = colours == RGB ? 3 : 1;
        require(
                samples == needed || samples == needed + 1 && (opacity == ASSOCIATED || opacity == UNASSOCIATED),
                "has " + samples + " samples a pixel for " + needed + (needed == 1 ? " colour" : " colours"),
                "have one for each colour, and one more at most, for opacity");
        require(colours != PALETTE || samples == 1, "has a palette and opacity", "have either");
    }

    private void requireNumbers() throws IOException {
        long bits = same(TIFF.TAG_BITS_PER_SAMPLE, 1, "numbers of bits");
        long format = same(TIFF.TAG_SAMPLE_FORMAT, UNSIGNED, "kinds of numbers");
        require(format != SIGNED, "its numbers are signed", "have unsigned or floating point numbers");
        require(
                format == UNSIGNED || format == FLOATING || format == UNDEFINED,
                "its numbers are complex or of an unknown kind",
                "have unsigned or floating point numbers");
        long predictor = tags.number(TIFF.TAG_PREDICTOR, 1);
        require(
                predictor == 1 || predictor == (format == FLOATING ? 3 : 2) && bits >= 8,
                "has predictor " + predictor + " for " + (format == FLOATING ? "floating point" : bits + " bits"),
                "have 1, 2 for whole numbers of 8 or 16 bits, or 3 for floating point");
        if (format == FLOATING) {
            require(bits == 32, "its numbers are floating point with " + bits + " bits", "have 32");
            require(
                    colours == BLACK_IS_ZERO || colours == RGB,
                    "0 is white and its numbers are floating point",
                    "have 0 as black");
        } else if (colours == PALETTE) {
            require(
                    bits == 1 || bits == 2 || bits == 4 || bits == 8,
                    "has a palette and " + bits + " bits a pixel",
                    "have up to 8 there");
        } else {
            require(
                    bits == 8 || bits == 16 || samples == 1 && (bits == 1 || bits == 2 || bits == 4),
                    "has " + bits + " bits a sample",
                    "have 8 or 16, or 32 in floating point");
        }
    }

    /** The number that a tag has for all samples of a pixel. */
    private long same(int tag, long otherwise, String what) throws IOException {
        long[] numbers = tags.numbers(tag);
        require(Arrays.stream(numbers).distinct().count() <= 1, "its samples have several " + what, "have one");
        return numbers.length == 0 ? otherwise : numbers[0];
    }

    private void require(boolean known, String property, String allowed) throws FileException {
        PictureEncoding.TIFF.require(known, name, property, allowed);
    }

    private static String named(Map<Long, String> names, long number) {
        String known = names.get(number);
        return known == null ? "number " + number : known + " (" + number + ")";
    }

    private Pixels pixels(Raster raster) throws IOException {
        Pixels stored = PixelDecoder.decode(raster, colours == PALETTE ? palette() : null);
        if (colours == WHITE_IS_ZERO) {
            stored.invert();
        }
        if (opacity == ASSOCIATED && samples > 1) {
            stored.divideByOpacity();
        }
        return tags.orientation().turn(stored);
    }

    /** The file has all reds first. Some programs write numbers of 8 bits although 16 are required. */
    private float[] palette() throws IOException {
        long[] numbers = tags.numbers(TIFF.TAG_COLOR_MAP);
        boolean bytes = Arrays.stream(numbers).allMatch(number -> number <= LARGEST_BYTE);
        int count = numbers.length / 3;
        float[] palette = new float[4 * count];
        Arrays.fill(palette, 1);
        for (int i = 0; i < 3 * count; i++) {
            palette[4 * (i % count) + i / count] = numbers[i] / (bytes ? LARGEST_BYTE : LARGEST_OF_PALETTE);
        }
        return palette;
    }
}
