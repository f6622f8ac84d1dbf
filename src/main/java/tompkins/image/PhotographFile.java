package tompkins.image;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import tompkins.file.FileException;
import tompkins.file.PendingFile;
import tompkins.file.WholeFile;

/** Saves photographs with the scene inside, and finds the scene in saved photographs. */
public final class PhotographFile {

    private static final List<String> PICTURE_ENDINGS =
            List.of(".png", ".tif", ".tiff", ".hdr", ".pic", ".jpg", ".jpeg", ".gif", ".bmp");

    private PhotographFile() {}

    /**
     * Saves a photograph. The file appears complete or not at all, and what was there before stays until then. The same
     * arguments give the same bytes.
     *
     * @param curve how light becomes levels; formats that hold the light itself do not need it
     * @param replace whether it replaces the file that has its name; otherwise, if that is taken when the photograph is
     *     complete, it gets the same with a number
     * @return where it lies
     * @throws FileException if the file's name does not fit the format, or the file cannot be written
     */
    public static Path write(
            Path file, LinearImage image, PictureFormat format, ToneCurve curve, PhotographInfo info, boolean replace)
            throws FileException {
        format.requireFor(file);
        return PendingFile.save(file, replace, out -> encode(out, image, format, curve, info));
    }

    /**
     * Whether a file is a picture, by its name or by how it begins; it need not hold a scene.
     *
     * @throws IOException if the file cannot be read
     */
    public static boolean isPicture(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return isPicture(file, in.readNBytes(PictureEncoding.LONGEST_START));
        }
    }

    /** Whether a file is a picture, by its name or by its first bytes, at least. */
    public static boolean isPicture(Path file, byte[] content) {
        return FileEndings.match(file, PICTURE_ENDINGS)
                || PictureEncoding.of(content).isPresent();
    }

    /**
     * Checks whether a photograph can be saved, before time is spent on taking it. Leaves everything as it was.
     *
     * @throws FileException if there is no such folder, or no permission to write there
     */
    public static void requireWritable(Path file) throws FileException {
        try {
            PendingFile.at(file, true).close();
        } catch (IOException e) {
            throw FileException.cannotWrite(file, e);
        }
    }

    /** Writes a photograph into a stream, with the bytes that its file would have. */
    public static void encode(
            OutputStream out, LinearImage image, PictureFormat format, ToneCurve curve, PhotographInfo info)
            throws IOException {
        switch (format) {
            case PNG -> PngFile.write(out, BufferedImages.toBufferedImage(image, curve), info);
            case PNG16 -> PngFile.write(out, BufferedImages.sixteenBit(image, curve), info);
            case TIFF -> TiffFile.write(out, BufferedImages.sixteenBit(image, curve), info);
            case TIFF_FLOAT -> TiffFile.write(out, BufferedImages.floatingPoint(image), info);
            case HDR -> RadianceFile.write(out, image, info);
        }
    }

    /**
     * The scene in a saved photograph, as it was given to {@link #write}; line ends may have become line feeds, and
     * letters may have become escapes of JSON or the reverse. The file is recognised by its content, not by its name.
     *
     * @return the JSON of the scene; empty if the picture holds none
     * @throws FileException if the file cannot be read, is damaged, or is not a PNG, TIFF or Radiance picture
     */
    public static Optional<String> readScene(Path file) throws FileException {
        try {
            return readScene(WholeFile.read(file), file.toString());
        } catch (IOException failure) {
            throw FileException.cannotRead(file, failure);
        }
    }

    /** As above, for the bytes of a file; its name is for messages. */
    public static Optional<String> readScene(byte[] content, String name) throws FileException {
        PictureEncoding encoding = PictureEncoding.of(content).orElseThrow(() -> notAPhotograph(name, "not a picture"));
        try {
            return switch (encoding) {
                case PNG -> PngFile.readScene(content);
                case TIFF -> TiffFile.readScene(content);
                case HDR -> RadianceFile.readScene(content);
                case JPEG, GIF, BMP -> throw notAPhotograph(name, "a " + encoding.label() + " picture");
            };
        } catch (IOException | RuntimeException damaged) {
            // The readers trust the file, and can fail in any way if it is damaged.
            throw FileException.cannotRead(name, damaged);
        }
    }

    private static FileException notAPhotograph(String name, String what) {
        return new FileException(
                name + ": " + what + "; a photograph that holds its scene is a PNG, TIFF or Radiance HDR picture");
    }

    /**
     * The format of a saved photograph, recognised by its content.
     *
     * @return the format; empty if the file is none of them, such as a scene file
     * @throws FileException if the file cannot be read, or is damaged
     */
    public static Optional<PictureFormat> format(Path file) throws FileException {
        try {
            byte[] content = WholeFile.read(file);
            PictureEncoding encoding = PictureEncoding.of(content).orElse(PictureEncoding.GIF);
            return switch (encoding) {
                case PNG -> Optional.of(content[PngFile.BIT_DEPTH_AT] == 16 ? PictureFormat.PNG16 : PictureFormat.PNG);
                case TIFF ->
                    Optional.of(TiffFile.isFloatingPoint(content) ? PictureFormat.TIFF_FLOAT : PictureFormat.TIFF);
                case HDR -> Optional.of(PictureFormat.HDR);
                case JPEG, GIF, BMP -> Optional.empty();
            };
        } catch (IOException | RuntimeException damaged) {
            throw FileException.cannotRead(file, damaged);
        }
    }

    /**
     * Checks that the picture of a saved photograph is whole by reading it to its last row: the scene comes first and
     * may be found in spite of damage. Does nothing for a file that is not a picture, such as a scene file.
     *
     * @throws FileException if the picture is damaged
     */
    public static void requireWhole(Path file) throws FileException {
        try {
            byte[] content = WholeFile.read(file);
            Optional<PictureEncoding> encoding = PictureEncoding.of(content);
            if (encoding.isPresent()) {
                PictureFile.pixels(encoding.get(), content, file.toString());
            }
        } catch (FileException e) {
            throw e;
        } catch (IOException | RuntimeException e) {
            throw new FileException(file + ": the picture is damaged: " + FileException.reason(e), e);
        }
    }
}
