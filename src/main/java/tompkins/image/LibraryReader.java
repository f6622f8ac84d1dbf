package tompkins.image;

import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream;
import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.EOFException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/** Reads pictures with the readers of the libraries. The size is checked before a picture is made. */
final class LibraryReader {

    private LibraryReader() {}

    /**
     * A picture as the library gives it.
     *
     * @throws IOException if the file is damaged, or ends too early
     */
    static BufferedImage image(PictureEncoding encoding, byte[] file, String name) throws IOException {
        return read(encoding, file, name, reader -> reader.read(0, reader.getDefaultReadParam()));
    }

    /**
     * The samples of a picture as they are stored, not converted.
     *
     * @throws IOException if the file is damaged, or ends too early
     */
    static Raster samples(PictureEncoding encoding, byte[] file, String name) throws IOException {
        return read(encoding, file, name, reader -> reader.readRaster(0, null));
    }

    /** What to ask a reader for. */
    private interface Wish<T> {
        T from(ImageReader reader) throws IOException;
    }

    private static <T> T read(PictureEncoding encoding, byte[] file, String name, Wish<T> wish) throws IOException {
        ImageReader reader = ImageProviders.reader(encoding);
        List<String> warnings = new ArrayList<>();
        try (ImageInputStream stream = new ByteArrayImageInputStream(file)) {
            reader.addIIOReadWarningListener((source, warning) -> warnings.add(warning));
            reader.setInput(stream, true, true);
            Pixels.requireSize(reader.getWidth(0), reader.getHeight(0), name);
            T picture = wish.from(reader);
            for (String warning : warnings) {
                // A JPEG picture that ends too early is filled with grey, and only a warning says so.
                if (warning.startsWith("Truncated File") || warning.contains("premature end")) {
                    throw new EOFException(warning);
                }
            }
            return picture;
        } finally {
            reader.dispose();
        }
    }
}
