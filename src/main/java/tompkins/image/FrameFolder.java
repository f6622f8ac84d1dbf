package tompkins.image;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import tompkins.file.FileException;
import tompkins.file.PendingFile;
import tompkins.file.WholeFile;

/**
 * A folder with the frames of a film, {@code frame0000.png}, {@code frame0001.png}, ..., to which several processes may
 * add. Each frame appears complete or not at all.
 *
 * @param folder where it lies; it need not exist
 */
public record FrameFolder(Path folder) {

    private static final Pattern NAME = Pattern.compile("frame([0-9]{4,9})\\.png");

    /** Where a frame, counted from 0, lies or would lie. */
    public Path file(int frame) {
        return folder.resolve(String.format(Locale.ROOT, "frame%04d.png", frame));
    }

    /** The numbers of the frames that are there, in order. */
    public List<Integer> frames() throws FileException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> NAME.matcher(file.getFileName().toString()))
                    .filter(Matcher::matches)
                    .map(name -> Integer.valueOf(name.group(1)))
                    .filter(this::isThere)
                    .sorted()
                    .toList();
        } catch (IOException failure) {
            throw FileException.cannotRead(folder, failure);
        }
    }

    /** Whether a frame is there, complete or damaged. An empty file, which a power failure may leave, is none. */
    public boolean isThere(int frame) {
        Path file = file(frame);
        return Files.exists(file)
                && !(Files.isRegularFile(file) && file.toFile().length() == 0);
    }

    /** Whether a frame is there and its picture can be read to the end. */
    public boolean isWhole(int frame) {
        try {
            PhotographFile.requireWhole(file(frame));
            return isThere(frame);
        } catch (FileException damaged) {
            return false;
        }
    }

    /** The scene and the description of a frame. */
    public PhotographInfo info(int frame) throws FileException {
        Path file = file(frame);
        try {
            return PngFile.readInfo(WholeFile.read(file));
        } catch (IOException | RuntimeException damaged) {
            // texts of other programs may be anything
            throw FileException.cannotRead(file, damaged);
        }
    }

    /** The picture of a frame. */
    public FramePicture picture(int frame) throws FileException {
        Path file = file(frame);
        try {
            BufferedImage read = ImageProviders.image(PictureEncoding.PNG, WholeFile.read(file), file.toString());
            BufferedImage picture = new BufferedImage(read.getWidth(), read.getHeight(), BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = picture.createGraphics();
            graphics.drawImage(read, 0, 0, null);
            graphics.dispose();
            return new FramePicture(picture);
        } catch (IOException failure) {
            throw FileException.cannotRead(file, failure);
        }
    }

    /** Writes a frame, in place of one that is there. The folder must exist. */
    public void write(int frame, FramePicture picture, PhotographInfo info) throws FileException {
        PendingFile.save(file(frame), true, out -> PngFile.write(out, picture.image(), info));
    }
}
