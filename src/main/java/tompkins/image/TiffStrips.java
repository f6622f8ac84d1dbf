package tompkins.image;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream;
import java.awt.image.DataBufferByte;
import java.awt.image.Raster;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/**
 * The strips or tiles of a TIFF file, unpacked. The library undoes the compression: each is handed to it as a grey
 * picture of bytes, since it knows only some of the samples that may be packed in them.
 */
final class TiffStrips {

    private static final int ONE_NUMBER = 4;

    /** Bytes of the marker at the start of a JPEG picture, and of that at its end. */
    private static final int JPEG_MARKER = 2;

    private final byte[] file;
    private final int compression;
    private final int fillOrder;
    private final long faxOptions;
    private final boolean isFax;
    private final boolean isJpeg;
    private final byte[] jpegTables;
    private final String name;
    private final long[] offsets;
    private final long[] lengths;
    private final int width;
    private final int height;
    private final boolean tiled;

    TiffStrips(byte[] file, TiffDirectory directory, TiffKind kind, int pictureWidth, int pictureHeight, String name)
            throws IOException {
        this.file = file;
        compression = kind.compression();
        isFax = kind.isFax();
        isJpeg = kind.isJpeg();
        jpegTables = bytes(directory.numbers(TIFF.TAG_JPEG_TABLES));
        this.name = name;
        fillOrder = (int) directory.number(TIFF.TAG_FILL_ORDER, 1);
        faxOptions = directory.number(
                compression == TiffKind.FAX_GROUP_4 ? TIFF.TAG_GROUP4OPTIONS : TIFF.TAG_GROUP3OPTIONS, 0);
        tiled = directory.has(TIFF.TAG_TILE_OFFSETS);
        offsets = directory.numbers(tiled ? TIFF.TAG_TILE_OFFSETS : TIFF.TAG_STRIP_OFFSETS);
        lengths = directory.numbers(tiled ? TIFF.TAG_TILE_BYTE_COUNTS : TIFF.TAG_STRIP_BYTE_COUNTS);
        long tileWidth = tiled ? directory.number(TIFF.TAG_TILE_WIDTH, 0) : pictureWidth;
        long tileHeight = tiled
                ? directory.number(TIFF.TAG_TILE_HEIGTH, 0)
                : directory.number(TIFF.TAG_ROWS_PER_STRIP, pictureHeight);
        if (!tiled && (tileHeight < 1 || tileHeight > pictureHeight)) {
            tileHeight = pictureHeight;
        }
        Pixels.requireSize(tileWidth, tileHeight, name + ": a tile");
        width = (int) tileWidth;
        height = (int) tileHeight;
    }

    /** Pixels in a row of a strip or tile. */
    int width() {
        return width;
    }

    /** Rows of a strip or tile; the last strip may have fewer. */
    int height() {
        return height;
    }

    /**
     * The first rows of a strip or tile.
     *
     * @param index which one
     * @param rowBytes how many bytes a row has
     */
    byte[] rows(int index, int rows, int rowBytes) throws IOException {
        if (index >= offsets.length || offsets[index] < 0 || offsets[index] >= file.length) {
            throw new EOFException("a strip of pixels lies outside the file");
        }
        int from = (int) offsets[index];
        long needed = (long) rows * rowBytes;
        if (compression == TiffKind.NOT_PACKED) {
            if (needed > file.length - from) {
                throw new EOFException("the file ends inside a strip of pixels");
            }
            byte[] plain = Arrays.copyOfRange(file, from, from + (int) needed);
            return fillOrder == 1 ? plain : reversed(plain);
        }
        boolean known = index < lengths.length && lengths[index] > 0 && lengths[index] < file.length - from;
        byte[] packed = Arrays.copyOfRange(file, from, known ? from + (int) lengths[index] : file.length);
        return isJpeg ? fromJpeg(packed, rows, rowBytes) : unpack(packed, rows, rowBytes);
    }

    private static byte[] bytes(long[] numbers) {
        byte[] bytes = new byte[numbers.length];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) numbers[i];
        }
        return bytes;
    }

    /**
     * The samples of a JPEG picture as they are, whatever its own markers say of its colours. Tables that all strips
     * share are a picture without pixels: start, tables, end.
     */
    private byte[] fromJpeg(byte[] packed, int rows, int rowBytes) throws IOException {
        ByteArrayOutputStream picture = new ByteArrayOutputStream();
        boolean shared = jpegTables.length > 2 * JPEG_MARKER;
        picture.write(jpegTables, 0, shared ? jpegTables.length - JPEG_MARKER : 0);
        int from = shared ? JPEG_MARKER : 0;
        picture.write(packed, from, packed.length - from);
        Raster samples = JpegReader.samples(picture.toByteArray(), name);
        if (samples.getWidth() * samples.getNumBands() != rowBytes || samples.getHeight() < rows) {
            throw new IOException("a strip of pixels has another size than the file says");
        }
        return ((DataBufferByte) samples.getDataBuffer()).getData();
    }

    private static byte[] reversed(byte[] bytes) {
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) (Integer.reverse(bytes[i]) >>> 24);
        }
        return bytes;
    }

    private byte[] unpack(byte[] packed, int rows, int rowBytes) throws IOException {
        ImageReader reader = ImageProviders.reader(PictureEncoding.TIFF);
        try (ImageInputStream stream = new ByteArrayImageInputStream(asPicture(packed, rows, rowBytes))) {
            reader.setInput(stream, true, true);
            return ((DataBufferByte) reader.readRaster(0, null).getDataBuffer()).getData();
        } finally {
            reader.dispose();
        }
    }

    /** A TIFF file with one strip: header, number of tags, tags, no further picture, pixels. */
    private byte[] asPicture(byte[] packed, int rows, int rowBytes) {
        int[][] tags = {
            {TIFF.TAG_IMAGE_WIDTH, isFax ? width : rowBytes},
            {TIFF.TAG_IMAGE_HEIGHT, rows},
            {TIFF.TAG_BITS_PER_SAMPLE, isFax ? 1 : 8},
            {TIFF.TAG_COMPRESSION, compression},
            {TIFF.TAG_PHOTOMETRIC_INTERPRETATION, 1},
            {TIFF.TAG_FILL_ORDER, fillOrder},
            {TIFF.TAG_STRIP_OFFSETS, 0},
            {TIFF.TAG_SAMPLES_PER_PIXEL, 1},
            {TIFF.TAG_ROWS_PER_STRIP, rows},
            {TIFF.TAG_STRIP_BYTE_COUNTS, packed.length},
            {compression == TiffKind.FAX_GROUP_4 ? TIFF.TAG_GROUP4OPTIONS : TIFF.TAG_GROUP3OPTIONS, (int) faxOptions},
        };
        int start = 8 + 2 + 12 * tags.length + 4;
        ByteBuffer picture = ByteBuffer.allocate(start + packed.length);
        picture.putInt(0x4d4d002a).putInt(8).putShort((short) tags.length);
        for (int[] tag : tags) {
            int value = tag[0] == TIFF.TAG_STRIP_OFFSETS ? start : tag[1];
            picture.putShort((short) tag[0])
                    .putShort((short) ONE_NUMBER)
                    .putInt(1)
                    .putInt(value);
        }
        return picture.putInt(0).put(packed).array();
    }
}
