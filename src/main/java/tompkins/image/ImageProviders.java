package tompkins.image;

import com.twelvemonkeys.imageio.plugins.tiff.TIFFImageReaderSpi;
import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream;
import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.EOFException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageReader;
import javax.imageio.ImageWriter;
import javax.imageio.spi.IIORegistry;
import javax.imageio.spi.ImageReaderSpi;
import javax.imageio.spi.ImageWriterSpi;
import javax.imageio.stream.ImageInputStream;

/**
 * The readers and writers of the libraries. The size of a picture is checked before it is made. Several providers are
 * installed for TIFF, and the first in the registry cannot write 16 bits or floating point, so each is chosen by its
 * class.
 */
final class ImageProviders {

    private ImageProviders() {}

    /** The JDK's writer; that for TIFF alone writes 16 bits and floating point. */
    static ImageWriter writer(PictureEncoding encoding) throws IOException {
        return provider(ImageWriterSpi.class, encoding, "ImageWriterSpi").createWriterInstance();
    }

    /** The JDK's reader, but for TIFF. */
    static ImageReader reader(PictureEncoding encoding) throws IOException {
        return encoding == PictureEncoding.TIFF
                ? new TIFFImageReaderSpi().createReaderInstance()
                : provider(ImageReaderSpi.class, encoding, "ImageReaderSpi").createReaderInstance();
    }

    private static <T> T provider(Class<T> category, PictureEncoding encoding, String kind) {
        String name = encoding.name();
        String className = "com.sun.imageio.plugins." + name.toLowerCase(Locale.ROOT) + "." + name + kind;
        Iterator<T> providers = IIORegistry.getDefaultInstance().getServiceProviders(category, false);
        while (providers.hasNext()) {
            T provider = providers.next();
            if (provider.getClass().getName().equals(className)) {
                return provider;
            }
        }
        throw new IllegalStateException("this Java has no " + className);
    }

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
        ImageReader reader = reader(encoding);
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
