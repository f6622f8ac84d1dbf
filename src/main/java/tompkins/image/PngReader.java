package tompkins.image;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import tompkins.file.FileException;

/**
 * Reads PNG pictures with the JDK's reader, which is handed only the chunks that say what the pixels are. It does not
 * check whether a chunk is damaged, and knows no transparent level of grey below 8 bits: the one is done here, and the
 * other refused.
 */
final class PngReader {

    private static final int GREY = 0;
    private static final int PALETTE = 3;
    private static final String COLOURS = "PLTE";
    private static final String TRANSPARENCY = "tRNS";
    private static final String HEADER = "IHDR";
    private static final String APPLE = "CgBI";

    /** After the signature and the length of the first chunk. */
    private static final int FIRST_TYPE_AT = PngChunk.SIGNATURE.length + 4;

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
        plain.writeBytes(PngChunk.SIGNATURE);
        int colours = colourType == PALETTE ? 0 : 1 << bitDepth;
        Orientation orientation = Orientation.TOP_LEFT;
        PngChunk chunk;
        int place = PngChunk.SIGNATURE.length;
        do {
            chunk = PngChunk.at(file, place);
            place += chunk.size();
            if (tellsPixels(chunk.type(), colourType)) {
                chunk.write(plain);
                colours = chunk.type().equals(COLOURS) ? chunk.data().length / 3 : colours;
                PictureEncoding.PNG.require(
                        !chunk.type().equals(TRANSPARENCY) || colourType != GREY || bitDepth >= Byte.SIZE,
                        name,
                        "has a transparent level of " + bitDepth + " bits",
                        "have one of 8 or 16 bits");
            } else if (chunk.type().equals("eXIf")) {
                orientation = TiffDirectory.exifOrientation(chunk.data());
            }
        } while (!chunk.isLast());
        BufferedImage image = ImageProviders.image(PictureEncoding.PNG, plain.toByteArray(), name);
        float[] palette = image.getColorModel() instanceof IndexColorModel model ? colours(model, colours) : null;
        return orientation.turn(PixelDecoder.decode(image.getRaster(), palette));
    }

    private static boolean tellsPixels(String type, int colourType) {
        return switch (type) {
            case HEADER, "IDAT", "IEND" -> true;
            case COLOURS -> colourType == PALETTE;
            case TRANSPARENCY -> colourType <= PALETTE;
            default -> false;
        };
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
}
