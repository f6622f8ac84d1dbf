package tompkins.image;

import com.twelvemonkeys.imageio.plugins.tiff.TIFFImageReaderSpi;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.ImageReader;
import javax.imageio.ImageWriter;
import javax.imageio.spi.IIORegistry;
import javax.imageio.spi.ImageReaderSpi;
import javax.imageio.spi.ImageWriterSpi;

/**
 * Which provider reads and writes which format. Several are installed for TIFF, and the first in the registry cannot
 * write 16 bits or floating point, so each is chosen by its class.
 */
final class ImageProviders {

    private static final String JDK = "com.sun.imageio.plugins.";

    private ImageProviders() {}

    static ImageWriter pngWriter() throws IOException {
        return provider(ImageWriterSpi.class, JDK + "png.PNGImageWriterSpi").createWriterInstance();
    }

    static ImageWriter gifWriter() throws IOException {
        return provider(ImageWriterSpi.class, JDK + "gif.GIFImageWriterSpi").createWriterInstance();
    }

    /** The JDK's, which alone writes 16 bits and floating point. */
    static ImageWriter tiffWriter() throws IOException {
        return provider(ImageWriterSpi.class, JDK + "tiff.TIFFImageWriterSpi").createWriterInstance();
    }

    /** The reader for the pixels of an encoding. */
    static ImageReader reader(PictureEncoding encoding) throws IOException {
        return switch (encoding) {
            case PNG -> jdkReader("png.PNGImageReaderSpi");
            case JPEG -> jdkReader("jpeg.JPEGImageReaderSpi");
            case TIFF -> new TIFFImageReaderSpi().createReaderInstance();
            case GIF, BMP, HDR -> throw new IllegalArgumentException("no library reads such pictures rightly");
        };
    }

    private static ImageReader jdkReader(String className) throws IOException {
        return provider(ImageReaderSpi.class, JDK + className).createReaderInstance();
    }

    private static <T> T provider(Class<T> category, String className) {
        Iterator<T> providers = IIORegistry.getDefaultInstance().getServiceProviders(category, false);
        while (providers.hasNext()) {
            T provider = providers.next();
            if (provider.getClass().getName().equals(className)) {
                return provider;
            }
        }
        throw new IllegalStateException("this Java has no " + className);
    }
}
