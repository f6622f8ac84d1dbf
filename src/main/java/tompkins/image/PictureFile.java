package tompkins.image;

import java.io.IOException;
import java.nio.file.Path;
import tompkins.file.FileException;
import tompkins.file.WholeFile;
import tompkins.ray.PixelPicture;

/**
 * Reads pictures of any origin, for surfaces and masks: PNG, JPEG, TIFF and Radiance. One rule holds for all of them:
 * numbers are taken as they are stored, whole numbers divided by the largest that their bits can hold, and no profile
 * and no tone curve is applied; the picture is turned as its orientation tag says; colours that are multiplied by their
 * opacity are divided by it. Of files with several pictures, the first is read.
 */
public final class PictureFile {

    /** The most pixels that a picture may have. */
    public static final int MOST_PIXELS = 64_000_000;

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
            Pixels pixels = pixels(encoding, file, name);
            pixels.requireFinite(name);
            return new PixelPicture(name, pixels.width(), pixels.height(), pixels.rgba(), file);
        } catch (FileException e) {
            throw e;
        } catch (IOException | RuntimeException e) {
            // The readers trust the file, and can fail in any way if it is damaged.
            throw new FileException(
                    name + ": " + encoding.label() + " picture cannot be read: " + FileException.reason(e), e);
        }
    }

    /**
     * The pixels of a picture, which are not checked for numbers that are not finite.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels pixels(PictureEncoding encoding, byte[] file, String name) throws IOException {
        return switch (encoding) {
            case PNG -> PngReader.read(file, name);
            case JPEG -> JpegReader.read(file, name);
            case GIF, BMP ->
                throw new FileException(name + ": is a " + encoding.label() + " picture; allowed are "
                        + PictureEncoding.ALLOWED + "; convert it to PNG, for example with ImageMagick or GIMP");
            case TIFF -> TiffReader.read(file, name);
            case HDR -> RadianceReader.read(file, name);
        };
    }
}
