package tompkins.image;

import com.twelvemonkeys.imageio.metadata.CompoundDirectory;
import com.twelvemonkeys.imageio.metadata.Directory;
import com.twelvemonkeys.imageio.metadata.Entry;
import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import com.twelvemonkeys.imageio.metadata.tiff.TIFFReader;
import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream;
import java.io.IOException;
import java.lang.reflect.Array;
import java.nio.ByteOrder;
import java.util.NavigableMap;
import java.util.TreeMap;
import javax.imageio.stream.ImageInputStream;

/**
 * The tags of the first picture in a TIFF file, and of the Exif data in files of other formats, which are written in
 * the same way.
 */
final class TiffDirectory {

    private final Directory directory;

    /** Where the bytes of the file begin that are no pixels, and where they end; the last are its end. */
    private final TreeMap<Long, Long> places = new TreeMap<>();

    private TiffDirectory(ImageInputStream file) throws IOException {
        Directory all = new TIFFReader().read(file);
        directory = all instanceof CompoundDirectory pictures ? pictures.getDirectory(0) : all;
        file.seek(0);
        file.setByteOrder(file.read() == 'I' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        file.seek(2);
        boolean isBig = file.readShort() == TIFF.BIGTIFF_MAGIC;
        file.seek(isBig ? 8 : 4);
        long start = isBig ? file.readLong() : file.readUnsignedInt();
        places.put(0L, isBig ? 16L : 8L);
        places.put(start, start + (isBig ? 16 + 20L * directory.size() : 6 + 12L * directory.size()));
        places.put(file.length(), file.length());
    }

    /** Reads the tags of a file, or of a part of one, that begins with the header of TIFF. */
    static TiffDirectory read(byte[] file) throws IOException {
        try (ImageInputStream stream = new ByteArrayImageInputStream(file)) {
            return new TiffDirectory(stream);
        }
    }

    /** The orientation in Exif data; damaged Exif data do not turn the picture. */
    static Orientation exifOrientation(byte[] exif) {
        try {
            return read(exif).orientation();
        } catch (IOException | RuntimeException e) {
            return Orientation.TOP_LEFT;
        }
    }

    /** How rows and columns lie in the picture. */
    Orientation orientation() throws IOException {
        return Orientation.ofTag(number(TIFF.TAG_ORIENTATION, 1));
    }

    /** The places of the file that no pixels can have: its header, its directory and its end, each with its own end. */
    NavigableMap<Long, Long> places() {
        return new TreeMap<>(places);
    }

    /** Whether there is such a tag. */
    boolean has(int tag) {
        return directory.getEntryById(tag) != null;
    }

    /** The value of a tag as the library gives it; null if there is no such tag. */
    Object value(int tag) throws IOException {
        Entry entry = directory.getEntryById(tag);
        Object value = entry == null ? null : entry.getValue();
        if (value instanceof IOException damage) {
            throw damage;
        }
        return value;
    }

    /** The first number of a tag, or another one if there is no such tag. */
    long number(int tag, long otherwise) throws IOException {
        long[] numbers = numbers(tag);
        return numbers.length == 0 ? otherwise : numbers[0];
    }

    /** All whole numbers of a tag; none if there is no such tag, or if it holds something else. */
    long[] numbers(int tag) throws IOException {
        Object value = value(tag);
        if (value instanceof Number number) {
            return new long[] {number.longValue()};
        }
        if (value == null
                || !value.getClass().isArray()
                || !value.getClass().getComponentType().isPrimitive()) {
            return new long[0];
        }
        long[] numbers = new long[Array.getLength(value)];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = ((Number) Array.get(value, i)).longValue();
        }
        return numbers;
    }
}
