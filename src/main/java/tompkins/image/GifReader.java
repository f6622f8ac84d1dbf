package tompkins.image;

import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream;
import java.io.IOException;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;

/** Reads the first frame of GIF pictures with the JDK's reader, except those that it reads wrongly. */
final class GifReader {

    private static final int LOWEST_INTERLACED = 5;
    private static final int SCREEN_AT = 6;

    private GifReader() {}

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        // The reader makes the whole screen, and the first frame may be only a part of it.
        Pixels.requireSize(littleEndian(file, SCREEN_AT), littleEndian(file, SCREEN_AT + 2), name);
        requireReadable(file, name);
        return LibraryReader.read(PictureEncoding.GIF, file, name);
    }

    private static void requireReadable(byte[] file, String name) throws IOException {
        ImageReader reader = ImageProviders.reader(PictureEncoding.GIF);
        try (ImageInputStream stream = new ByteArrayImageInputStream(file)) {
            reader.setInput(stream, true, true);
            if (reader.getHeight(0) < LOWEST_INTERLACED && isInterlaced(reader)) {
                // The JDK's reader gives such a picture without an error, but without the rows after the first.
                throw new FileException(name + ": an interlaced GIF picture must have " + LOWEST_INTERLACED
                        + " rows or more, has " + reader.getHeight(0) + "; save it without interlacing");
            }
        } finally {
            reader.dispose();
        }
    }

    private static boolean isInterlaced(ImageReader reader) throws IOException {
        var root = (IIOMetadataNode) reader.getImageMetadata(0).getAsTree("javax_imageio_gif_image_1.0");
        var descriptor =
                (IIOMetadataNode) root.getElementsByTagName("ImageDescriptor").item(0);
        return descriptor.getAttribute("interlaceFlag").equalsIgnoreCase("true");
    }

    private static int littleEndian(byte[] file, int at) {
        return file[at] & 0xff | (file[at + 1] & 0xff) << 8;
    }
}
