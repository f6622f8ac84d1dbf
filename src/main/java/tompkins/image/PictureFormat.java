package tompkins.image;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import tompkins.file.FileException;

/** The formats in which photographs are saved. Of those that share an ending, the first is the usual one. */
public enum PictureFormat {

    /** PNG, 8 bits per channel. */
    PNG("an 8-bit PNG picture", List.of(".png")),

    /** PNG, 16 bits per channel. */
    PNG16("a 16-bit PNG picture", List.of(".png")),

    /** TIFF, 16 bits per channel. */
    TIFF("a 16-bit TIFF picture", List.of(".tif", ".tiff")),

    /** TIFF, 32-bit floating point: the light itself, exactly, with no tone curve. */
    TIFF_FLOAT("a floating-point TIFF picture", List.of(".tif", ".tiff")),

    /** Radiance RGBE: the light itself, to one part in 128 of the brightest channel, with no tone curve. */
    HDR("a Radiance picture", List.of(".hdr", ".pic"));

    private final String description;
    private final List<String> endings;

    PictureFormat(String description, List<String> endings) {
        this.description = description;
        this.endings = endings;
    }

    /**
     * The usual format for a file's name.
     *
     * @throws FileException if the name has none of the endings that are allowed, or nothing before it
     */
    public static PictureFormat of(Path file) throws FileException {
        List<String> allowed = Stream.of(values())
                .flatMap(format -> format.endings.stream())
                .distinct()
                .toList();
        FileEndings.require(file, allowed, "a photograph");
        return Stream.of(values())
                .filter(format -> format.fits(file))
                .findFirst()
                .orElseThrow();
    }

    /** The endings of file names in this format, the usual one first. */
    public List<String> endings() {
        return endings;
    }

    /** Whether a file's name has an ending of this format. */
    public boolean fits(Path file) {
        return FileEndings.match(file, endings);
    }

    /**
     * Checks that a file's name fits this format.
     *
     * @throws FileException if the name has none of this format's endings, or nothing before it
     */
    public void requireFor(Path file) throws FileException {
        FileEndings.require(file, endings, description);
    }
}
