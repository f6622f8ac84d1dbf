package tompkins.image;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.io.IOException;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Reads the first picture of TIFF files (TIFF 6.0, BigTIFF). The library reads the tags and undoes the compression;
 * what the samples mean is read here, since the library knows few numbers of bits, forgets which of them are opacity,
 * and converts floating point.
 */
final class TiffReader {

    private static final int OPACITY = 3;
    private static final int CHANNELS = 4;
    private static final float LARGEST_BYTE = 255;
    private static final float LARGEST_OF_PALETTE = 65535;

    private final TiffKind kind;
    private final TiffDirectory directory;
    private final int width;
    private final int height;
    private final float[] rgba;

    private TiffReader(TiffKind kind, TiffDirectory directory, int width, int height) {
        this.kind = kind;
        this.directory = directory;
        this.width = width;
        this.height = height;
        this.rgba = new float[CHANNELS * width * height];
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        TiffDirectory directory = TiffDirectory.read(file);
        long width = directory.number(TIFF.TAG_IMAGE_WIDTH, 0);
        long height = directory.number(TIFF.TAG_IMAGE_HEIGHT, 0);
        Pixels.requireSize(width, height, name);
        TiffKind kind = TiffKind.of(directory, name);
        Pixels stored;
        if (kind.isLeftToLibrary()) {
            stored = LibraryReader.read(PictureEncoding.TIFF, file, name);
        } else {
            TiffReader reader = new TiffReader(kind, directory, (int) width, (int) height);
            reader.readSamples(file, name);
            reader.makeColours(name);
            stored = new Pixels((int) width, (int) height, reader.rgba);
        }
        return directory.orientation().turn(stored);
    }

    private void readSamples(byte[] file, String name) throws IOException {
        TiffStrips strips = new TiffStrips(file, directory, kind, width, height, name);
        ByteOrder order = file[0] == 'I' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
        int predictor = kind.predictor(directory, name);
        int index = 0;
        for (TiffBlock block : TiffBlock.all(directory, kind, channels(), name)) {
            int columns = parts(strips.width(), block.across());
            TiffSamples samples = new TiffSamples(block.bits(), kind.floating(), order, predictor, columns);
            for (int y = 0; y < height; y += strips.height()) {
                for (int x = 0; x < width; x += strips.width()) {
                    readStrip(strips, index++, samples, block, x, y);
                }
            }
        }
    }

    private static int parts(int whole, int part) {
        return (whole + part - 1) / part;
    }

    /** Which channel each sample of a pixel is; -1 for those that do not belong to its colour. */
    private int[] channels() {
        int[] channels = new int[kind.bits().length];
        Arrays.fill(channels, -1);
        for (int i = 0; i < kind.colours().samples(); i++) {
            channels[i] = i;
        }
        if (kind.opacity() >= 0) {
            channels[kind.opacity()] = OPACITY;
        }
        return channels;
    }

    private void readStrip(TiffStrips strips, int index, TiffSamples samples, TiffBlock block, int left, int top)
            throws IOException {
        boolean indices = kind.colours() == TiffKind.Colours.PALETTE;
        int rows = parts(Math.min(strips.height(), height - top), block.down());
        int columns = parts(Math.min(strips.width(), width - left), block.across());
        int rowBytes = Math.toIntExact(samples.rowBytes());
        byte[] packed = strips.rows(index, rows, rowBytes);
        for (int row = 0; row < rows; row++) {
            samples.read(packed, row * rowBytes);
            for (int column = 0; column < columns; column++) {
                for (int sample = 0; sample < block.channels().length; sample++) {
                    int channel = block.channels()[sample];
                    if (channel >= 0) {
                        float value =
                                indices && channel == 0 ? samples.code(column, sample) : samples.value(column, sample);
                        put(value, block, sample, left + column * block.across(), top + row * block.down());
                    }
                }
            }
        }
    }

    /** Puts a sample into its pixel, or into all pixels of its block, as far as they lie in the picture. */
    private void put(float value, TiffBlock block, int sample, int left, int top) {
        boolean single = sample < block.luminances();
        int fromX = single ? left + sample % block.across() : left;
        int fromY = single ? top + sample / block.across() : top;
        int toX = Math.min(width, single ? fromX + 1 : left + block.across());
        int toY = Math.min(height, single ? fromY + 1 : top + block.down());
        for (int y = fromY; y < toY; y++) {
            for (int x = fromX; x < toX; x++) {
                rgba[CHANNELS * (y * width + x) + block.channels()[sample]] = value;
            }
        }
    }

    private void makeColours(String name) throws IOException {
        float[] palette = kind.colours() == TiffKind.Colours.PALETTE ? palette() : null;
        TiffLuminance luminance = kind.colours() == TiffKind.Colours.LUMINANCE_AND_CHROMINANCE
                ? new TiffLuminance(directory, kind, name)
                : null;
        for (int pixel = 0; pixel < rgba.length; pixel += CHANNELS) {
            if (kind.opacity() < 0) {
                rgba[pixel + OPACITY] = 1;
            }
            switch (kind.colours()) {
                case WHITE_IS_ZERO -> Arrays.fill(rgba, pixel, pixel + OPACITY, 1 - rgba[pixel]);
                case BLACK_IS_ZERO -> Arrays.fill(rgba, pixel, pixel + OPACITY, rgba[pixel]);
                case PALETTE -> lookUp(palette, pixel);
                case LUMINANCE_AND_CHROMINANCE -> luminance.toColour(rgba, pixel);
                case RGB -> {}
            }
            if (kind.multiplied() && palette == null) {
                divideByOpacity(pixel);
            }
        }
    }

    private void divideByOpacity(int pixel) {
        float opacity = rgba[pixel + OPACITY];
        for (int channel = 0; channel < OPACITY && opacity > 0; channel++) {
            rgba[pixel + channel] /= opacity;
        }
    }

    private void lookUp(float[] palette, int pixel) throws IOException {
        int colours = palette.length / 3;
        int index = (int) rgba[pixel];
        if (index >= colours) {
            throw new IOException("a pixel's colour is not in the palette");
        }
        for (int channel = 0; channel < 3; channel++) {
            rgba[pixel + channel] = palette[channel * colours + index];
        }
    }

    /** The palette: all reds, all greens, all blues. Some programs write numbers of 8 bits although 16 are required. */
    private float[] palette() throws IOException {
        long[] numbers = directory.numbers(TIFF.TAG_COLOR_MAP);
        boolean bytes = Arrays.stream(numbers).allMatch(number -> number <= LARGEST_BYTE);
        float[] palette = new float[numbers.length];
        for (int i = 0; i < palette.length; i++) {
            palette[i] = numbers[i] / (bytes ? LARGEST_BYTE : LARGEST_OF_PALETTE);
        }
        return palette;
    }
}
