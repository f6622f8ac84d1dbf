package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Drawings with at most 256 colours, whose PNG files are half as large. */
public final class FewColours {

    private FewColours() {}

    /** A copy of an opaque picture with a palette, whose colours are those that the JDK chooses for a GIF. */
    public static BufferedImage of(BufferedImage picture) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageWriter writer = ImageProviders.gifWriter();
            try (ImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
                writer.setOutput(out);
                writer.write(picture);
            } finally {
                writer.dispose();
            }
            return LibraryReader.image(PictureEncoding.GIF, bytes.toByteArray(), "drawing");
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }
}
