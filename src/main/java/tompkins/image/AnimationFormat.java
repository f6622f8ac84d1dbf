package tompkins.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import tompkins.file.FileException;
import tompkins.file.PendingFile;

/** The formats in which animations are saved. They play forever if the format can say so. */
public enum AnimationFormat {

    /** Animated GIF: at most 256 colours a frame, delays in hundredths of a second and not below two of them. */
    GIF("an animated GIF", List.of(".gif")),

    /** H.264 video, made by the program ffmpeg where it is installed; not exact. */
    MP4("an MP4 video", List.of(".mp4")),

    /**
     * A folder of PNG pictures {@code frame0000.png}, {@code frame0001.png}, ..., each with its scene inside: exact.
     */
    NUMBERED_PNG("a folder of numbered PNG pictures", List.of());

    /** The most frames a second; screens show no more. */
    public static final int FASTEST = 60;

    private final String description;
    private final List<String> endings;

    AnimationFormat(String description, List<String> endings) {
        this.description = description;
        this.endings = endings;
    }

    /** The endings that the name of a file in this format may have; none for a folder. */
    public List<String> endings() {
        return endings;
    }

    /**
     * The format for a name: that of its ending, and numbered pictures for a name without one.
     *
     * @throws FileException if no animation has this ending
     */
    public static AnimationFormat of(Path target) throws FileException {
        for (AnimationFormat format : values()) {
            if (FileEndings.match(target, format.endings)) {
                return format;
            }
        }
        Path name = target.getFileName();
        if (name != null && name.toString().lastIndexOf('.') > 0) {
            throw new FileException(target + ": the name of an animation must end in .gif or .mp4, or have no ending,"
                    + " for a folder of numbered PNG pictures");
        }
        return NUMBERED_PNG;
    }

    /** The most frames a second that this format can show. */
    public int fastest() {
        return this == GIF ? GifWriter.FASTEST : FASTEST;
    }

    /**
     * Begins an animation.
     *
     * @param target the file, or for numbered pictures the folder, which must be new or empty
     * @param framesPerSecond from 1 to {@link #FASTEST}
     * @param replace whether it replaces the file that has its name; otherwise, if that is taken when the animation is
     *     complete, it gets a name with a number
     * @throws FileException if the name does not fit the format, the format cannot show so many frames, nothing can be
     *     written there, or ffmpeg is missing
     * @throws IllegalArgumentException if {@code framesPerSecond} is out of range
     */
    public AnimationWriter open(Path target, int framesPerSecond, boolean replace) throws FileException {
        if (framesPerSecond < 1 || framesPerSecond > FASTEST) {
            throw new IllegalArgumentException(
                    "framesPerSecond must be a whole number from 1 to " + FASTEST + ", was " + framesPerSecond);
        }
        if (!endings.isEmpty()) {
            FileEndings.require(target, endings, description);
        }
        if (framesPerSecond > fastest()) {
            throw new FileException(target + ": " + description + " can show at most " + fastest()
                    + " pictures a second, the film has " + framesPerSecond
                    + "; give the film fewer, or save it as .mp4 or as a folder of pictures");
        }
        try {
            return switch (this) {
                case GIF -> new GifWriter(target, PendingFile.at(target, replace), framesPerSecond);
                case MP4 -> {
                    Path program = Mp4Writer.program(Objects.requireNonNullElse(System.getenv("PATH"), ""));
                    yield new Mp4Writer(target, PendingFile.at(target, replace), framesPerSecond, program);
                }
                case NUMBERED_PNG -> NumberedPngWriter.in(target);
            };
        } catch (IOException e) {
            throw FileException.cannotWrite(target, e);
        }
    }
}
