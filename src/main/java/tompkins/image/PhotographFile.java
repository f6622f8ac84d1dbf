package tompkins.image;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
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
        if (FileEndings.match(file, PICTURE_ENDINGS)) {
            return true;
        }
        try (InputStream in = Files.newInputStream(file)) {
            return PictureEncoding.of(in.readNBytes(PictureEncoding.LONGEST_START))
                    .isPresent();
        }
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
            return scene(file, encoding(file).orElseThrow(() -> notAPhotograph(file, "not a picture")));
        } catch (IOException e) {
            throw FileException.cannotRead(file, e);
        } catch (RuntimeException e) {
            // The readers trust the file, and can fail in any way if it is damaged.
            throw FileException.cannotRead(file, new IOException(e));
        }
    }

    /** Whether bytes are a picture, by how they begin. */
    public static boolean isPicture(byte[] content) {
        return PictureEncoding.of(content).isPresent();
    }

    /**
     * The scene in the bytes of a PNG photograph; otherwise as {@link #readScene(Path)}.
     *
     * @param name for messages
     * @throws FileException if the picture is damaged, or of another kind
     */
    public static Optional<String> readScene(byte[] content, String name) throws FileException {
        PictureEncoding encoding = PictureEncoding.of(content).orElse(null);
        if (encoding != PictureEncoding.PNG) {
            throw new FileException(name + ": only PNG photographs can be read through a pipe; name the file");
        }
        try {
            return PngFile.readScene(new ByteArrayInputStream(content));
        } catch (IOException | RuntimeException damaged) {
            throw new FileException(name + ": the picture is damaged: " + FileException.reason(damaged), damaged);
        }
    }

    /**
     * The format of a saved photograph, recognised by its content.
     *
     * @return the format; empty if the file is none of them, such as a scene file
     * @throws FileException if the file cannot be read, or is damaged
     */
    public static Optional<PictureFormat> format(Path file) throws FileException {
        try (InputStream in = Files.newInputStream(file)) {
            byte[] start = in.readNBytes(PngFile.BIT_DEPTH_AT + 1);
            PictureEncoding encoding = PictureEncoding.of(start).orElse(null);
            if (encoding == PictureEncoding.PNG && start.length > PngFile.BIT_DEPTH_AT) {
                return Optional.of(start[PngFile.BIT_DEPTH_AT] == 16 ? PictureFormat.PNG16 : PictureFormat.PNG);
            }
            if (encoding == PictureEncoding.TIFF) {
                return Optional.of(TiffFile.isFloatingPoint(file) ? PictureFormat.TIFF_FLOAT : PictureFormat.TIFF);
            }
            return encoding == PictureEncoding.HDR ? Optional.of(PictureFormat.HDR) : Optional.empty();
        } catch (IOException e) {
            throw FileException.cannotRead(file, e);
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
            PictureEncoding encoding = encoding(file).orElse(null);
            if (encoding != null) {
                PictureFile.pixels(encoding, WholeFile.read(file), file.toString());
            }
        } catch (FileException e) {
            throw e;
        } catch (IOException | RuntimeException e) {
            throw new FileException(file + ": the picture is damaged: " + FileException.reason(e), e);
        }
    }

    private static Optional<PictureEncoding> encoding(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return PictureEncoding.of(in.readNBytes(PictureEncoding.LONGEST_START));
        }
    }

    private static Optional<String> scene(Path file, PictureEncoding encoding) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            return switch (encoding) {
                case PNG -> PngFile.readScene(in);
                case TIFF -> TiffFile.readScene(file);
                case HDR -> RadianceFile.readScene(in);
                default -> throw notAPhotograph(file, "a " + encoding.label() + " picture");
            };
        }
    }

    private static FileException notAPhotograph(Path file, String what) {
        return new FileException(
                file + ": " + what + "; a photograph that holds its scene is a PNG, TIFF or Radiance HDR picture");
    }
}
