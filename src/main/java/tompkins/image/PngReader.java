package tompkins.image;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Reads PNG pictures with the JDK's reader, which is handed only the chunks that say what the pixels are. It knows no
 * transparent level of grey below 8 bits, so transparent levels and colours are found here.
 */
final class PngReader {

    private static final int COLOUR_TYPE_AT = PngFile.BIT_DEPTH_AT + 1;
    private static final int GREY = 0;
    private static final int RGB = 2;
    private static final int PALETTE = 3;
    private static final int LENGTH_AND_TYPE = 8;
    private static final String TRANSPARENCY = "tRNS";
    private static final String APPLE = "CgBI";

    private final byte[] file;
    private final int bitDepth;
    private final int colourType;
    private final ByteArrayOutputStream plain;
    private Orientation orientation = Orientation.TOP_LEFT;

    /** The levels of the channels of what is transparent; empty if nothing is. */
    private int[] transparent = {};

    private PngReader(byte[] file) {
        this.file = file;
        this.bitDepth = file.length > COLOUR_TYPE_AT ? file[PngFile.BIT_DEPTH_AT] : 0;
        this.colourType = file.length > COLOUR_TYPE_AT ? file[COLOUR_TYPE_AT] : 0;
        this.plain = new ByteArrayOutputStream(file.length);
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        PngReader reader = new PngReader(file);
        reader.readChunks(name);
        BufferedImage image = LibraryReader.image(PictureEncoding.PNG, reader.plain.toByteArray(), name);
        Pixels pixels = PixelDecoder.decode(image);
        if (reader.transparent.length > 0) {
            reader.clear(pixels, image.getRaster());
        }
        return reader.orientation.turn(pixels);
    }

    /**
     * Goes through the chunks up to the last; what lies behind it is not of this picture. If the file ends too early,
     * the library will say so.
     */
    private void readChunks(String name) throws IOException {
        int at = PngChunk.SIGNATURE_LENGTH;
        plain.write(file, 0, Math.min(at, file.length));
        String type = "";
        while (file.length - at >= PngChunk.FRAME && !type.equals("IEND")) {
            int length = ByteBuffer.wrap(file).getInt(at);
            type = new String(file, at + 4, 4, StandardCharsets.ISO_8859_1);
            if (type.equals(APPLE)) {
                throw new FileException(name + ": is packed in a way that only Apple devices read (" + APPLE
                        + "); save it as an ordinary PNG picture");
            }
            int rest = file.length - at - (int) PngChunk.FRAME;
            boolean whole = length >= 0 && length <= rest;
            int size = whole ? length : rest;
            int end = at + LENGTH_AND_TYPE + size;
            byte[] data = Arrays.copyOfRange(file, at + LENGTH_AND_TYPE, end);
            if (type.equals("IHDR") && data.length >= 2 * Integer.BYTES) {
                requireSize(ByteBuffer.wrap(data), name);
            }
            boolean needed = tellsPixels(type) || type.equals(TRANSPARENCY);
            if (needed
                    && whole
                    && new PngChunk(type, data).checksum()
                            != ByteBuffer.wrap(file).getInt(end)) {
                throw PngChunk.damaged(at);
            }
            if (tellsPixels(type)) {
                plain.write(file, at, size + (int) PngChunk.FRAME);
            }
            readChunk(type, data);
            at += size + (int) PngChunk.FRAME;
        }
    }

    private static void requireSize(ByteBuffer header, String name) throws FileException {
        Pixels.requireSize(Integer.toUnsignedLong(header.getInt()), Integer.toUnsignedLong(header.getInt()), name);
    }

    private boolean tellsPixels(String type) {
        return switch (type) {
            case "IHDR", "IDAT", "IEND" -> true;
            case "PLTE", TRANSPARENCY -> colourType == PALETTE;
            default -> false;
        };
    }

    private void readChunk(String type, byte[] data) {
        int channels = colourType == GREY ? 1 : colourType == RGB ? 3 : 0;
        if (type.equals(TRANSPARENCY) && data.length >= 2 * channels) {
            transparent = new int[channels];
            for (int i = 0; i < channels; i++) {
                // Always two bytes; if there are fewer bits, the upper ones mean nothing.
                transparent[i] = ByteBuffer.wrap(data).getShort(2 * i) & (1 << bitDepth) - 1;
            }
        } else if (type.equals("eXIf")) {
            orientation = TiffDirectory.exifOrientation(data);
        }
    }

    private void clear(Pixels pixels, Raster levels) {
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
