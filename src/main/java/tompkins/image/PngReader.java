package tompkins.image;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import tompkins.file.FileException;

/**
 * Reads PNG pictures with the JDK's reader, which is handed only the chunks that say what the pixels are. It does not
 * check whether a chunk is damaged, and knows no transparent level of grey below 8 bits, so both are done here.
 */
final class PngReader {

    private static final int GREY = 0;
    private static final int RGB = 2;
    private static final int PALETTE = 3;
    private static final String COLOURS = "PLTE";
    private static final String TRANSPARENCY = "tRNS";
    private static final String HEADER = "IHDR";
    private static final String APPLE = "CgBI";

    /** After the signature and the length of the first chunk. */
    private static final int FIRST_TYPE_AT = PngChunk.SIGNATURE_LENGTH + 4;

    private PngReader() {}

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        String firstType = new String(file, FIRST_TYPE_AT, APPLE.length(), StandardCharsets.ISO_8859_1);
        PictureEncoding.PNG.require(
                firstType.equals(HEADER),
                name,
                "begins with " + (firstType.equals(APPLE) ? "what only Apple devices read (" + APPLE + ")" : firstType),
                "begin with its header (" + HEADER + ")");
        ByteBuffer header = ByteBuffer.wrap(file).position(FIRST_TYPE_AT + APPLE.length());
        Pixels.requireSize(Integer.toUnsignedLong(header.getInt()), Integer.toUnsignedLong(header.getInt()), name);
        int bitDepth = header.get();
        int colourType = header.get();
        ByteArrayOutputStream plain = new ByteArrayOutputStream(file.length);
        PngChunk.writeSignature(plain);
        int[] transparent = {};
        int colours = colourType == PALETTE ? 0 : 1 << bitDepth;
        Orientation orientation = Orientation.TOP_LEFT;
        PngChunk chunk;
        int place = PngChunk.SIGNATURE_LENGTH;
        do {
            chunk = PngChunk.at(file, place);
            place += chunk.size();
            if (tellsPixels(chunk.type(), colourType)) {
                chunk.write(plain);
                colours = chunk.type().equals(COLOURS) ? chunk.data().length / 3 : colours;
            } else if (chunk.type().equals(TRANSPARENCY)) {
                transparent = levels(chunk.data(), colourType == GREY ? 1 : colourType == RGB ? 3 : 0, bitDepth);
            } else if (chunk.type().equals("eXIf")) {
                orientation = TiffDirectory.exifOrientation(chunk.data());
            }
        } while (!chunk.isLast());
        BufferedImage image = ImageProviders.image(PictureEncoding.PNG, plain.toByteArray(), name);
        float[] palette = image.getColorModel() instanceof IndexColorModel model ? colours(model, colours) : null;
        Pixels pixels = PixelDecoder.decode(image.getRaster(), palette);
        if (transparent.length > 0) {
            clear(pixels, image.getRaster(), transparent);
        }
        return orientation.turn(pixels);
    }

    private static boolean tellsPixels(String type, int colourType) {
        return switch (type) {
            case HEADER, "IDAT", "IEND" -> true;
            case COLOURS, TRANSPARENCY -> colourType == PALETTE;
            default -> false;
        };
    }

    /**
     * The levels of what is transparent: always two bytes each; if there are fewer bits, the upper ones mean nothing.
     */
    private static int[] levels(byte[] data, int channels, int bitDepth) throws IOException {
        if (data.length < 2 * channels) {
            throw new IOException("a transparent colour is not complete");
        }
        int[] levels = new int[channels];
        for (int i = 0; i < channels; i++) {
            levels[i] = ByteBuffer.wrap(data).getShort(2 * i) & (1 << bitDepth) - 1;
        }
        return levels;
    }

    /** The colours that the file has; the library adds as many as there are numbers for. */
    private static float[] colours(IndexColorModel model, int count) {
        float[] palette = new float[4 * Math.min(count, model.getMapSize())];
        for (int i = 0; i < palette.length / 4; i++) {
            palette[4 * i] = model.getRed(i) / 255f;
            palette[4 * i + 1] = model.getGreen(i) / 255f;
            palette[4 * i + 2] = model.getBlue(i) / 255f;
            palette[4 * i + 3] = model.getAlpha(i) / 255f;
        }
        return palette;
    }

    private static void clear(Pixels pixels, Raster levels, int[] transparent) {
        int[] pixel = new int[levels.getNumBands()];
        for (int y = 0, opacity = 3; y < pixels.height(); y++) {
            for (int x = 0; x < pixels.width(); x++, opacity += 4) {
                if (Arrays.equals(levels.getPixel(x, y, pixel), transparent)) {
                    pixels.rgba()[opacity] = 0;
                }
            }
        }
    }
}
