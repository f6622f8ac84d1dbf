package tompkins.image;

import com.twelvemonkeys.imageio.plugins.hdr.HDRImageReadParam;
import com.twelvemonkeys.imageio.plugins.hdr.tonemap.NullToneMapper;
import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;
import tompkins.ray.PixelPicture;

/**
 * Reads pictures of any origin, for surfaces and masks: PNG, JPEG, GIF, BMP, TIFF and Radiance. Values are taken as
 * they are stored, divided by the largest for whole numbers: no tone curve is undone, orientation tags are ignored, and
 * only the first frame of an animation is read.
 */
public final class PictureFile {

    /** The most pixels that a picture may have. */
    public static final int MOST_PIXELS = 64_000_000;

    private static final int LOWEST_INTERLACED = 5;

    private PictureFile() {}

    /**
     * Reads a picture, named after the file.
     *
     * @throws FileException if there is no such file, it is too large, or it is not a picture that can be read
     */
    public static PixelPicture read(Path file) throws FileException {
        try {
            return read(WholeFile.read(file), file.getFileName().toString());
        } catch (IOException e) {
            throw FileException.cannotRead(file, e);
        }
    }

    /**
     * Reads a picture from the bytes of its file. The array is handed over and must not be changed afterwards.
     *
     * @param name the file's name, for messages and for {@link PixelPicture#name}
     * @throws FileException if they are not a picture that can be read
     */
    public static PixelPicture read(byte[] file, String name) throws FileException {
        if (file.length == 0) {
            throw new FileException(name + ": the file is empty; allowed are " + PictureEncoding.ALLOWED);
        }
        PictureEncoding encoding = PictureEncoding.of(file)
                .orElseThrow(() -> new FileException(
                        name + ": not a picture that can be read; allowed are " + PictureEncoding.ALLOWED));
        try {
            return decode(encoding, file, name);
        } catch (FileException e) {
            throw e;
        } catch (IOException | RuntimeException e) {
            // The readers trust the file and fail in any way when it is damaged.
            throw damaged(encoding, name, FileException.reason(e), e);
        }
    }

    private static FileException damaged(PictureEncoding encoding, String name, String reason, Throwable cause) {
        return new FileException(name + ": " + encoding.label() + " picture cannot be read: " + reason, cause);
    }

    private static PixelPicture decode(PictureEncoding encoding, byte[] file, String name) throws IOException {
        ImageReader reader = ImageProviders.reader(encoding);
        List<String> warnings = new ArrayList<>();
        try (ImageInputStream stream = new ByteArrayImageInputStream(file)) {
            reader.addIIOReadWarningListener((source, warning) -> warnings.add(warning));
            reader.setInput(stream, true, true);
            requireSize(reader, encoding, file, name);
            PixelPicture picture = pixels(reader, encoding, file, name);
            for (String warning : warnings) {
                // A JPEG picture that ends too early is filled with grey, and only a warning tells.
                if (warning.startsWith("Truncated File") || warning.contains("premature end")) {
                    throw new EOFException(warning);
                }
            }
            return picture;
        } finally {
            reader.dispose();
        }
    }

    private static PixelPicture pixels(ImageReader reader, PictureEncoding encoding, byte[] file, String name)
            throws IOException {
        ImageTypeSpecifier stored = encoding == PictureEncoding.TIFF ? reader.getRawImageType(0) : null;
        if (stored != null && isFloatingPoint(stored)) {
            // Not read(), which clips floating point to [0, 1].
            var raster = reader.readRaster(0, null);
            float[] rgba = PixelDecoder.rgba(raster, stored.getColorModel(), name);
            return new PixelPicture(name, raster.getWidth(), raster.getHeight(), rgba, file);
        }
        BufferedImage image = reader.read(0, parameters(reader, encoding));
        float[] rgba = PixelDecoder.rgba(image.getRaster(), image.getColorModel(), name);
        return new PixelPicture(name, image.getWidth(), image.getHeight(), rgba, file);
    }

    private static boolean isFloatingPoint(ImageTypeSpecifier type) {
        int dataType = type.getSampleModel().getDataType();
        return dataType == DataBuffer.TYPE_FLOAT || dataType == DataBuffer.TYPE_DOUBLE;
    }

    private static ImageReadParam parameters(ImageReader reader, PictureEncoding encoding) {
        if (encoding != PictureEncoding.HDR) {
            return reader.getDefaultReadParam();
        }
        HDRImageReadParam param = new HDRImageReadParam();
        param.setToneMapper(new NullToneMapper());
        return param;
    }

    /** Believes no header: the size is checked before anything of that size is made. */
    private static void requireSize(ImageReader reader, PictureEncoding encoding, byte[] file, String name)
            throws IOException {
        requireSize(reader.getWidth(0), reader.getHeight(0), name);
        switch (encoding) {
            case GIF -> requireReadableGif(reader, file, name);
            case HDR -> requirePackedRows(reader.getWidth(0), name);
            default -> {}
        }
    }

    private static void requireReadableGif(ImageReader reader, byte[] file, String name) throws IOException {
        // The reader makes the whole screen, of which the first frame may be a part.
        requireSize(littleEndian(file, 6), littleEndian(file, 8), name);
        if (reader.getHeight(0) < LOWEST_INTERLACED && isInterlaced(reader)) {
            // The JDK's reader gives such a picture without an error, but with the rows after the first missing.
            throw new FileException(name + ": an interlaced GIF picture must have " + LOWEST_INTERLACED
                    + " rows or more, has " + reader.getHeight(0) + "; save it without interlacing");
        }
    }

    private static boolean isInterlaced(ImageReader reader) throws IOException {
        var root = (IIOMetadataNode) reader.getImageMetadata(0).getAsTree("javax_imageio_gif_image_1.0");
        var descriptor =
                (IIOMetadataNode) root.getElementsByTagName("ImageDescriptor").item(0);
        return descriptor.getAttribute("interlaceFlag").equalsIgnoreCase("true");
    }

    private static void requirePackedRows(int width, String name) throws FileException {
        if (!RadianceFile.isPacked(width)) {
            throw new FileException(name + ": a Radiance picture must be from " + RadianceFile.NARROWEST_PACKED + " to "
                    + RadianceFile.WIDEST_PACKED + " pixels wide, is " + width);
        }
    }

    private static void requireSize(int width, int height, String name) throws FileException {
        if (width < 1 || height < 1 || (long) width * height > MOST_PIXELS) {
            throw new FileException(name + ": claims to have " + width + " x " + height
                    + " pixels; a picture may have from 1 to " + MOST_PIXELS);
        }
    }

    private static int littleEndian(byte[] file, int at) {
        return file[at] & 0xff | (file[at + 1] & 0xff) << 8;
    }
}
