package tompkins.image;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.awt.image.Raster;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.NavigableMap;
import java.util.Set;
import tompkins.file.FileException;

/**
 * Reads the first picture of TIFF files (TIFF 6.0, BigTIFF) with the library. One check comes before: the picture must
 * be of a kind that is known to come out right, and all its bytes must be there, because the library shows whatever
 * stands in their place.
 */
final class TiffReader {

    private static final int WHITE_IS_ZERO = 0;
    private static final int RGB = 2;
    private static final int PALETTE = 3;

    private static final long NOT_PACKED = 1;
    private static final long PACK_BITS = 32773;
    private static final Set<Long> PACKINGS = Set.of(NOT_PACKED, 5L, 8L, PACK_BITS, 32946L);

    /** The kinds of numbers, as the tag counts them from 1. */
    private static final List<String> FORMATS =
            List.of("unsigned", "signed", "floating-point", "untyped", "complex signed", "complex floating-point");

    private static final int FLOATING = 3;
    private static final int ASSOCIATED = 1;
    private static final int UNASSOCIATED = 2;

    private static final float LARGEST_BYTE = 255;
    private static final float LARGEST_OF_PALETTE = 65535;

    private final TiffDirectory tags;
    private final String name;
    private final long colours;
    private final long samples;
    private final long bits;
    private final long compression;

    /** The kind of opacity, 0 for none. */
    private final long opacity;

    /**
     * Reads the tags.
     *
     * @throws FileException if they are not of a kind that is read
     * @throws IOException if bytes of the picture are missing
     */
    private TiffReader(TiffDirectory tags, String name) throws IOException {
        this.tags = tags;
        this.name = name;
        colours = tags.number(TIFF.TAG_PHOTOMETRIC_INTERPRETATION, -1);
        samples = tags.number(TIFF.TAG_SAMPLES_PER_PIXEL, 1);
        bits = tags.number(TIFF.TAG_BITS_PER_SAMPLE, 1);
        compression = tags.number(TIFF.TAG_COMPRESSION, NOT_PACKED);
        opacity = tags.number(TIFF.TAG_EXTRA_SAMPLES, 0);
        requireKind();
        requireBytes();
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        TiffReader reader = new TiffReader(TiffDirectory.read(file), name);
        return reader.pixels(ImageProviders.samples(PictureEncoding.TIFF, file, name));
    }

    private void requireKind() throws IOException {
        Pixels.requireSize(tags.number(TIFF.TAG_IMAGE_WIDTH, 0), tags.number(TIFF.TAG_IMAGE_HEIGHT, 0), name);
        require(
                PACKINGS.contains(compression),
                "has compression number " + compression,
                "have none (1), LZW (5), Deflate (8) or PackBits (32773)");
        require(
                colours >= WHITE_IS_ZERO && colours <= PALETTE,
                "has colours of kind " + colours,
                "be grey (0 or 1), red, green and blue (2), or of a palette (3)");
        int needed = colours == RGB ? 3 : 1;
        boolean hasOpacity = opacity == ASSOCIATED || opacity == UNASSOCIATED;
        require(
                samples == needed || samples == needed + 1 && hasOpacity && colours != PALETTE,
                "has " + samples + " samples a pixel for " + (colours == PALETTE ? "a palette" : needed + " of colour"),
                "have one for each colour, and one more at most, for opacity, which a palette does not have");
        long format = tags.number(TIFF.TAG_SAMPLE_FORMAT, 1);
        boolean isOneKind = isSame(TIFF.TAG_BITS_PER_SAMPLE) && isSame(TIFF.TAG_SAMPLE_FORMAT);
        String kind = format >= 1 && format <= FORMATS.size() ? FORMATS.get((int) format - 1) : "unknown";
        require(
                isOneKind && (format == FLOATING ? isFloatRead() : (format == 1 || format == 4) && isWholeRead()),
                isOneKind ? "has " + kind + " samples of " + bits + " bits" : "has several kinds of samples",
                "have unsigned ones of 8 or 16 bits, or of 1, 2, 4 or 8 for a palette or grey alone,"
                        + " or floating-point ones of 32 bits with 0 as black");
        long predictor = tags.number(TIFF.TAG_PREDICTOR, 1);
        boolean isPredicted = compression != NOT_PACKED && predictor != 1;
        require(
                !isPredicted || compression != PACK_BITS && bits >= 8 && predictor == (format == FLOATING ? 3 : 2),
                "has predictor " + predictor + " for " + kind + " samples of " + bits + " bits",
                "have 1, or with LZW and Deflate 2 for 8 or 16 bits, or 3 for floating point");
    }

    private boolean isFloatRead() {
        return bits == 32 && colours != WHITE_IS_ZERO && colours != PALETTE;
    }

    private boolean isWholeRead() {
        boolean isFew = bits == 1 || bits == 2 || bits == 4;
        return bits == 8 || (colours == PALETTE ? isFew : bits == 16 || isFew && samples == 1);
    }

    private boolean isSame(int tag) throws IOException {
        return Arrays.stream(tags.numbers(tag)).distinct().count() <= 1;
    }

    private void require(boolean known, String property, String allowed) throws FileException {
        PictureEncoding.TIFF.require(known, name, property, allowed);
    }

    /** Refuses strips and tiles that are not in the file as a whole, each in a place of its own. */
    private void requireBytes() throws IOException {
        long height = tags.number(TIFF.TAG_IMAGE_HEIGHT, 0);
        long stripRows = Math.min(height, tags.number(TIFF.TAG_ROWS_PER_STRIP, height));
        boolean isTiled = tags.has(TIFF.TAG_TILE_WIDTH);
        long columns = tags.number(TIFF.TAG_TILE_WIDTH, tags.number(TIFF.TAG_IMAGE_WIDTH, 0));
        long rows = tags.number(TIFF.TAG_TILE_HEIGTH, stripRows);
        String part = isTiled ? "tile" : "strip";
        require(
                columns >= 1 && rows >= 1 && rows <= PictureFile.MOST_PIXELS / columns,
                "has " + part + "s of " + columns + " x " + rows + " pixels",
                "have from 1 to " + PictureFile.MOST_PIXELS + " in each");
        boolean isPlanar = tags.number(TIFF.TAG_PLANAR_CONFIGURATION, 1) == 2;
        long across = (tags.number(TIFF.TAG_IMAGE_WIDTH, 0) + columns - 1) / columns;
        long down = (height + rows - 1) / rows;
        long count = across * down * (isPlanar ? samples : 1);
        boolean hasTiles = tags.has(TIFF.TAG_TILE_OFFSETS);
        long[] starts = tags.numbers(hasTiles ? TIFF.TAG_TILE_OFFSETS : TIFF.TAG_STRIP_OFFSETS);
        long[] sizes = tags.numbers(hasTiles ? TIFF.TAG_TILE_BYTE_COUNTS : TIFF.TAG_STRIP_BYTE_COUNTS);
        if (starts.length < count || sizes.length < count) {
            throw new IOException("it lists " + Math.min(starts.length, sizes.length) + " " + part + "s of " + count);
        }
        long rowBytes = (columns * bits * (isPlanar ? 1 : samples) + 7) / 8;
        NavigableMap<Long, Long> taken = tags.places();
        for (int i = 0; i < count; i++) {
            long ownRows = isTiled ? rows : Math.min(rows, height - i % down * rows);
            long least = compression == NOT_PACKED ? rowBytes * ownRows : 1;
            if (sizes[i] < least) {
                throw new IOException("bytes are missing: " + part + " " + i + " has " + sizes[i] + ", and needs "
                        + (least == 1 ? "some" : least));
            }
            if (!takes(taken, starts[i], sizes[i])) {
                boolean isBeyond = starts[i] > taken.lastKey() - sizes[i];
                throw new IOException(part + " " + i + " is said to lie at byte " + starts[i] + " and to have "
                        + sizes[i] + (isBeyond ? ", but the file ends before" : ", where the file has something else"));
            }
        }
    }

    /** Takes bytes for a part of the picture, unless some are taken or are none of the file. */
    private static boolean takes(NavigableMap<Long, Long> taken, long start, long size) {
        var before = taken.floorEntry(start);
        Long after = taken.ceilingKey(start);
        boolean isFree = before != null && before.getValue() <= start && after != null && size <= after - start;
        if (isFree) {
            taken.put(start, start + size);
        }
        return isFree;
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
