package tompkins.image;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.io.IOException;
import java.util.Arrays;

/**
 * What the numbers of a TIFF picture mean (TIFF 6.0). Every kind that is not read is refused with its name.
 *
 * @param colours what the colour channels are
 * @param bits the bits of each sample of a pixel
 * @param floating whether the samples are floating point
 * @param opacity which sample is the opacity, -1 for none
 * @param multiplied whether the colours are multiplied by the opacity
 * @param compression how the samples are packed, as a number of the tag
 */
record TiffKind(Colours colours, int[] bits, boolean floating, int opacity, boolean multiplied, int compression) {

    /** What the colour channels of a pixel are. */
    enum Colours {
        WHITE_IS_ZERO(1),
        BLACK_IS_ZERO(1),
        RGB(3),
        PALETTE(1),
        /** Luminance and two differences, blue and red. */
        LUMINANCE_AND_CHROMINANCE(3);

        private final int samples;

        Colours(int samples) {
            this.samples = samples;
        }

        /** How many samples of a pixel are its colour. */
        int samples() {
            return samples;
        }
    }

    static final int NOT_PACKED = 1;
    static final int FAX_ROWS = 2;
    static final int FAX_GROUP_3 = 3;
    static final int FAX_GROUP_4 = 4;
    private static final int OLD_JPEG = 6;
    private static final int JPEG = 7;
    private static final int PACK_BITS = 32773;

    private static final int UNSIGNED = 1;
    private static final int SIGNED = 2;
    private static final int FLOATING = 3;
    private static final int UNDEFINED = 4;
    private static final int ASSOCIATED = 1;
    private static final int UNASSOCIATED = 2;

    /** The most samples that a pixel may have; files with more hold measurements and not a picture. */
    private static final int MOST_SAMPLES = 256;

    /**
     * Reads the kind from the tags.
     *
     * @throws FileException if it is one that is not read
     */
    static TiffKind of(TiffDirectory directory, String name) throws IOException {
        int compression = compression(directory, name);
        long samples = directory.number(TIFF.TAG_SAMPLES_PER_PIXEL, 1);
        Colours colours = colours(directory, compression, samples, name);
        if (samples < colours.samples() || samples > MOST_SAMPLES) {
            throw new FileException(name + ": has " + samples + " samples a pixel; its colours need from "
                    + colours.samples() + " to " + MOST_SAMPLES);
        }
        if (compression == OLD_JPEG && samples > colours.samples()) {
            throw new FileException(name + ": has " + samples + " samples a pixel;"
                    + " a TIFF picture with JPEG of the old kind (compression 6) must have " + colours.samples());
        }
        boolean floating = isFloating(directory, (int) samples, name);
        int[] bits = bits(directory, (int) samples, name);
        long[] further = furtherSamples(directory, (int) samples - colours.samples());
        int opacity = opacity(further);
        TiffKind kind = new TiffKind(
                colours,
                bits,
                floating,
                opacity < 0 ? -1 : colours.samples() + opacity,
                opacity >= 0 && further[opacity] == ASSOCIATED,
                compression);
        kind.requireBits(name);
        return kind;
    }

    /** Whether the library has to turn the samples into colours: they cannot be told without all of the old tags. */
    boolean isLeftToLibrary() {
        return compression == OLD_JPEG;
    }

    /** Whether each strip or tile is a JPEG picture. */
    boolean isJpeg() {
        return compression == JPEG;
    }

    /**
     * The number of the predictor, which says whether samples are stored as differences; 1 for none, as with all
     * compressions for which it is not meant.
     *
     * @throws FileException if it is none that is known
     */
    int predictor(TiffDirectory directory, String name) throws IOException {
        if (compression == NOT_PACKED || compression == PACK_BITS || isFax() || isJpeg()) {
            return 1;
        }
        long predictor = directory.number(TIFF.TAG_PREDICTOR, 1);
        if (predictor < 1 || predictor > TiffSamples.DIFFERENCES_OF_BYTES) {
            throw new FileException(
                    name + ": its predictor is number " + predictor + "; that of a TIFF picture must be 1, 2 or 3");
        }
        if (predictor == TiffSamples.DIFFERENCES_OF_BYTES && !floating) {
            throw new FileException(name + ": its predictor is number 3, which is for floating point,"
                    + " and its numbers are whole; their predictor must be 1 or 2");
        }
        return (int) predictor;
    }

    /** Whether the samples are packed as for fax. */
    boolean isFax() {
        return compression >= FAX_ROWS && compression <= FAX_GROUP_4;
    }

    private static int compression(TiffDirectory directory, String name) throws IOException {
        int compression = (int) directory.number(TIFF.TAG_COMPRESSION, NOT_PACKED);
        return switch (compression) {
            case NOT_PACKED, FAX_ROWS, FAX_GROUP_3, FAX_GROUP_4, 5, OLD_JPEG, JPEG, 8, PACK_BITS, 32946, 50013 ->
                compression;
            default ->
                throw new FileException(name + ": its compression is " + compressionName(compression)
                        + "; a TIFF picture must have none, LZW, Deflate, PackBits, JPEG or fax");
        };
    }

    /** Numbers and names as registered with Adobe, and those of LibTIFF. */
    private static String compressionName(int compression) {
        String known = switch (compression) {
            case 9, 34661 -> "JBIG";
            case 10 -> "JBIG with colours";
            case 32766 -> "NeXT run lengths";
            case 32771 -> "fax in words of 16 bits";
            case 32809 -> "ThunderScan";
            case 34676, 34677 -> "SGI LogLuv";
            case 34712, 33003, 33004, 33005 -> "JPEG 2000";
            case 34887 -> "LERC";
            case 34892 -> "lossy JPEG of DNG";
            case 34925 -> "LZMA";
            case 34933 -> "PNG";
            case 34934, 22610 -> "JPEG XR";
            case 50000, 34926 -> "Zstandard";
            case 50001, 34927 -> "WebP";
            case 50002, 52546 -> "JPEG XL";
            default -> "";
        };
        return known.isEmpty() ? "number " + compression : known + " (" + compression + ")";
    }

    private static Colours colours(TiffDirectory directory, int compression, long samples, String name)
            throws IOException {
        int photometric = (int) directory.number(TIFF.TAG_PHOTOMETRIC_INTERPRETATION, -1);
        return switch (photometric) {
            case -1 -> likelyColours(directory, compression, samples);
            case 0 -> Colours.WHITE_IS_ZERO;
            case 1 -> Colours.BLACK_IS_ZERO;
            case 2 -> Colours.RGB;
            case 3 -> Colours.PALETTE;
            case 6 -> Colours.LUMINANCE_AND_CHROMINANCE;
            default ->
                throw new FileException(name + ": its colours are " + coloursName(photometric)
                        + "; those of a TIFF picture must be grey, red, green and blue, or of a palette");
        };
    }

    private static String coloursName(int photometric) {
        return switch (photometric) {
            case 4 -> "a mask for another picture (photometric interpretation 4)";
            case 5 -> "inks, as cyan, magenta, yellow and black (photometric interpretation 5)";
            case 8, 9, 10 -> "CIE L*a*b* (photometric interpretation " + photometric + ")";
            case 32803, 34892 -> "raw numbers of a camera (photometric interpretation " + photometric + ")";
            case 32844, 32845 -> "logarithms, SGI LogLuv (photometric interpretation " + photometric + ")";
            default -> "of an unknown kind (photometric interpretation " + photometric + ")";
        };
    }

    /** The colours if the tag is missing: it is required, but there are files without it. */
    private static Colours likelyColours(TiffDirectory directory, int compression, long samples) {
        if (directory.has(TIFF.TAG_COLOR_MAP)) {
            return Colours.PALETTE;
        }
        if (compression >= FAX_ROWS && compression <= FAX_GROUP_4) {
            return Colours.WHITE_IS_ZERO;
        }
        return samples < Colours.RGB.samples() ? Colours.BLACK_IS_ZERO : Colours.RGB;
    }

    private static boolean isFloating(TiffDirectory directory, int samples, String name) throws IOException {
        long[] formats = perSample(directory.numbers(TIFF.TAG_SAMPLE_FORMAT), UNSIGNED, samples);
        long first = formats[0] == UNDEFINED ? UNSIGNED : formats[0];
        for (long format : formats) {
            if (format == SIGNED) {
                throw new FileException(
                        name + ": its numbers are signed; those of a picture must be unsigned or floating point");
            }
            if (format != UNSIGNED && format != FLOATING && format != UNDEFINED) {
                throw new FileException(name + ": its numbers are "
                        + (format == 5 || format == 6 ? "complex" : "of an unknown kind (sample format " + format + ")")
                        + "; those of a picture must be unsigned or floating point");
            }
            if ((format == FLOATING) != (first == FLOATING)) {
                throw new FileException(name + ": has whole numbers and floating point in one pixel;"
                        + " those of a TIFF picture must be of one kind");
            }
        }
        return first == FLOATING;
    }

    /** One number for each sample; if there are fewer numbers, the first counts for all. */
    private static long[] perSample(long[] numbers, long otherwise, int samples) {
        if (numbers.length >= samples) {
            return Arrays.copyOf(numbers, samples);
        }
        long[] equal = new long[samples];
        Arrays.fill(equal, numbers.length == 0 ? otherwise : numbers[0]);
        return equal;
    }

    private static int[] bits(TiffDirectory directory, int samples, String name) throws IOException {
        long[] bits = perSample(directory.numbers(TIFF.TAG_BITS_PER_SAMPLE), 1, samples);
        for (long each : bits) {
            if (each < 1 || each > 64) {
                throw new FileException(
                        name + ": has " + each + " bits a sample; a TIFF picture must have from 1 to 32,"
                                + " or floating point with 16, 32 or 64");
            }
        }
        return Arrays.stream(bits).mapToInt(each -> (int) each).toArray();
    }

    private void requireBits(String name) throws FileException {
        for (int each : bits) {
            if (floating && each != 16 && each != 32 && each != 64) {
                throw new FileException(name + ": its numbers are floating point with " + each
                        + " bits; those of a TIFF picture must have 16, 32 or 64");
            }
            if (!floating && each > 32) {
                throw new FileException(name + ": its numbers are whole numbers of " + each
                        + " bits; those of a TIFF picture must have from 1 to 32");
            }
        }
        boolean fits = isFax()
                ? bits.length == 1 && bits[0] == 1
                : isJpeg() || isLeftToLibrary()
                        ? !floating && Arrays.stream(bits).allMatch(each -> each == 8)
                        : switch (colours) {
                            case PALETTE -> !floating && bits[0] <= 16;
                            case LUMINANCE_AND_CHROMINANCE -> !floating && (bits[0] == 8 || bits[0] == 16);
                            default -> true;
                        };
        if (!fits) {
            throw new FileException(
                    name + ": has " + bits[0] + " bits a sample" + (floating ? " in floating point" : "")
                            + ", which a TIFF picture with its compression or its colours may not have");
        }
    }

    /** What the samples after the colours are; without a tag, the first is the opacity. */
    private static long[] furtherSamples(TiffDirectory directory, int count) throws IOException {
        long[] told = directory.numbers(TIFF.TAG_EXTRA_SAMPLES);
        return Arrays.copyOf(told.length > 0 ? told : new long[] {UNASSOCIATED}, count);
    }

    private static int opacity(long[] further) {
        for (int i = 0; i < further.length; i++) {
            if (further[i] == ASSOCIATED || further[i] == UNASSOCIATED) {
                return i;
            }
        }
        return -1;
    }
}
