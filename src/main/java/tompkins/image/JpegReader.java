package tompkins.image;

import java.awt.image.Raster;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Reads JPEG pictures (ITU-T T.81) with the JDK's reader, which is handed a plain file: left to itself, it converts by
 * embedded profiles, takes YCbCr pictures without a marker of JFIF or Adobe for RGB, and gives no reason when it
 * refuses a picture.
 */
final class JpegReader {

    private static final int START_OF_IMAGE = 0xd8;
    private static final int END_OF_IMAGE = 0xd9;
    private static final int START_OF_SCAN = 0xda;
    private static final int COMMENT = 0xfe;
    private static final int FIRST_APPLICATION = 0xe0;
    private static final int EXIF = 0xe1;
    private static final int ADOBE = 0xee;
    private static final int LAST_APPLICATION = 0xef;
    private static final int JPEG_LS = 0xf7;

    /** Markers without a segment: restarts, start and end. */
    private static final int FIRST_BARE = 0xd0;

    /**
     * Codes among those of frames that do not begin a frame: tables, an extension, conditioning of arithmetic codes.
     */
    private static final byte[] NO_FRAMES = {(byte) 0xc4, (byte) 0xc8, (byte) 0xcc};

    private static final int FIRST_FRAME = 0xc0;
    private static final int PROGRESSIVE = 0xc2;
    private static final int LAST_FRAME = 0xcf;

    private static final byte[] EXIF_START = {'E', 'x', 'i', 'f', 0, 0};
    private static final byte[] RGB_COMPONENTS = {'R', 'G', 'B'};

    private static final byte[] JFIF_SEGMENT = {
        (byte) 0xff, (byte) 0xe0, 0, 16, 'J', 'F', 'I', 'F', 0, 1, 1, 0, 0, 1, 0, 1, 0, 0
    };
    private static final byte[] ADOBE_RGB_SEGMENT = {
        (byte) 0xff, (byte) 0xee, 0, 14, 'A', 'd', 'o', 'b', 'e', 0, 100, 0, 0, 0, 0, 0
    };

    private final byte[] file;
    private final String name;
    private final ByteArrayOutputStream kept = new ByteArrayOutputStream();
    private Orientation orientation = Orientation.TOP_LEFT;
    private boolean exifSeen;
    private boolean jfif;
    private int adobeTransform = -1;
    private byte[] components = {};
    private int pixelsAt;

    private JpegReader(byte[] file, String name) {
        this.file = file;
        this.name = name;
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        JpegReader reader = new JpegReader(file, name);
        reader.readSegments();
        reader.requireColours();
        return reader.orientation.turn(LibraryReader.read(PictureEncoding.JPEG, reader.plainFile(), name));
    }

    /**
     * The samples of a picture that is a part of another file, which says what they mean.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if it is damaged
     */
    static Raster samples(byte[] file, String name) throws IOException {
        JpegReader reader = new JpegReader(file, name);
        reader.readSegments();
        return LibraryReader.samples(PictureEncoding.JPEG, reader.plainFile(), name);
    }

    /** The file with one marker that says what its colours are, and without profiles, thumbnails and comments. */
    private byte[] plainFile() {
        ByteArrayOutputStream plain = new ByteArrayOutputStream(file.length);
        plain.write(0xff);
        plain.write(START_OF_IMAGE);
        plain.writeBytes(isRgb() ? ADOBE_RGB_SEGMENT : JFIF_SEGMENT);
        plain.writeBytes(kept.toByteArray());
        plain.write(file, pixelsAt, file.length - pixelsAt);
        return plain.toByteArray();
    }

    /**
     * Decides as the library of the Independent JPEG Group does: by JFIF, then Adobe's marker, then the components'
     * names.
     */
    private boolean isRgb() {
        return components.length == 3
                && !jfif
                && (adobeTransform >= 0 ? adobeTransform == 0 : Arrays.equals(components, RGB_COMPONENTS));
    }

    private void readSegments() throws IOException {
        int at = 2;
        while (true) {
            at = nextMarker(at);
            int marker = file[at] & 0xff;
            if (marker == END_OF_IMAGE) {
                throw new EOFException("the picture has no pixels");
            }
            if (marker == START_OF_SCAN) {
                pixelsAt = at - 1;
                return;
            }
            int end = at + 1;
            if (marker != 1 && (marker < FIRST_BARE || marker > START_OF_IMAGE)) {
                end = at + 1 + bigEndian(at + 1);
                readSegment(marker, at + 3, end);
            }
            at = end;
        }
    }

    /** The place of the code of the next marker; bytes of 255 before it are padding. */
    private int nextMarker(int from) throws IOException {
        int at = from;
        while (unsigned(at) != 0xff) {
            at++;
        }
        while (unsigned(at) == 0xff) {
            at++;
        }
        return at;
    }

    private int bigEndian(int at) throws IOException {
        return unsigned(at) << 8 | unsigned(at + 1);
    }

    private int unsigned(int at) throws IOException {
        if (at >= file.length) {
            throw new EOFException("the file ends before its pixels");
        }
        return file[at] & 0xff;
    }

    private void readSegment(int marker, int from, int end) throws IOException {
        if (end < from || end > file.length) {
            throw new EOFException("the file ends inside a segment");
        }
        if (marker >= FIRST_APPLICATION && marker <= LAST_APPLICATION) {
            readApplication(marker, Arrays.copyOfRange(file, from, end));
        } else if (marker != COMMENT) {
            if (marker == JPEG_LS || isFrame(marker)) {
                readFrame(marker, from);
            }
            kept.write(file, from - 4, end - from + 4);
        }
    }

    private static boolean isFrame(int marker) {
        return marker >= FIRST_FRAME && marker <= LAST_FRAME && Arrays.binarySearch(NO_FRAMES, (byte) marker) < 0;
    }

    private void readApplication(int marker, byte[] data) {
        if (marker == FIRST_APPLICATION && startsWith(data, "JFIF\0")) {
            jfif = true;
        } else if (marker == ADOBE && startsWith(data, "Adobe") && data.length >= 12) {
            adobeTransform = data[11] & 0xff;
        } else if (marker == EXIF && !exifSeen && startsWith(data, "Exif\0")) {
            exifSeen = true;
            orientation = TiffDirectory.exifOrientation(Arrays.copyOfRange(data, EXIF_START.length, data.length));
        }
    }

    private static boolean startsWith(byte[] data, String start) {
        byte[] bytes = start.getBytes(StandardCharsets.ISO_8859_1);
        return data.length >= EXIF_START.length && Arrays.equals(data, 0, bytes.length, bytes, 0, bytes.length);
    }

    /**
     * The segment: bits of a sample, height, width, components with three bytes each, of which the first is the name.
     */
    private void readFrame(int marker, int from) throws IOException {
        if (marker > PROGRESSIVE) {
            throw new FileException(
                    name + ": its coding is " + coding(marker) + "; a JPEG picture must be baseline or progressive");
        }
        int bits = unsigned(from);
        if (bits != 8) {
            throw new FileException(name + ": has " + bits + " bits a sample; a JPEG picture must have 8");
        }
        // The library has a limit of its own, and no reason.
        Pixels.requireSize(bigEndian(from + 3), bigEndian(from + 1), name);
        components = new byte[unsigned(from + 5)];
        for (int i = 0; i < components.length; i++) {
            components[i] = (byte) unsigned(from + 6 + 3 * i);
        }
    }

    private void requireColours() throws FileException {
        if (components.length != 1 && components.length != 3) {
            throw new FileException(name + ": has " + components.length
                    + (components.length == 4
                            ? " colours, as for printing in cyan, magenta, yellow and black"
                            : " colours")
                    + "; a JPEG picture must be grey or red, green and blue");
        }
    }

    private static String coding(int marker) {
        return switch (marker) {
            case 0xc3 -> "lossless";
            case 0xc5, 0xc6, 0xc7 -> "hierarchical";
            case JPEG_LS -> "JPEG-LS";
            default -> "arithmetic";
        };
    }
}
