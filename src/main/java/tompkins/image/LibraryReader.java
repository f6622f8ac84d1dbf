package tompkins.image;

import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream;
import java.awt.image.BufferedImage;
import java.io.EOFException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/** Reads the pixels of pictures with the readers of the libraries. */
final class LibraryReader {

    private LibraryReader() {}

    /** The pixels of a picture. */
    static Pixels read(PictureEncoding encoding, byte[] file, String name) throws IOException {
        return PixelDecoder.decode(image(encoding, file, name));
    }

    /**
     * A picture as the library gives it. Its size is checked before it is made.
     *
     * @throws IOException if the file is damaged, or ends too early
     */
    static BufferedImage image(PictureEncoding encoding, byte[] file, String name) throws IOException {
        ImageReader reader = ImageProviders.reader(encoding);
        List<String> warnings = new ArrayList<>();
        try (ImageInputStream stream = new ByteArrayImageInputStream(file)) {
            reader.addIIOReadWarningListener((source, warning) -> warnings.add(warning));
            reader.setInput(stream, true, true);
            Pixels.requireSize(reader.getWidth(0), reader.getHeight(0), name);
            BufferedImage image = reader.read(0, reader.getDefaultReadParam());
            for (String warning : warnings) {
                // A JPEG picture that ends too early is filled with grey, and only a warning says so.
                if (warning.startsWith("Truncated File") || warning.contains("premature end")) {
                    throw new EOFException(warning);
                }
            }
            return image;
        } finally {
            reader.dispose();
        }
    }
}
