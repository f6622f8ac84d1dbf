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

    /**
     * Begins an animation in one file; a {@link FrameFolder} takes numbered pictures.
     *
     * @param framesPerSecond from 1 to {@link #FASTEST}
     * @param replace whether it replaces the file that has its name; otherwise, if that is taken when the animation is
     *     complete, it gets a name with a number
     * @throws FileException if the name does not fit the format, the format cannot show so many frames, nothing can be
     *     written there, or ffmpeg is missing
     */
    public AnimationWriter open(Path target, int framesPerSecond, boolean replace) throws FileException {
        FileEndings.require(target, endings, description);
        if (this == GIF && framesPerSecond > GifWriter.FASTEST) {
            throw new FileException(target + ": " + description + " can show at most " + GifWriter.FASTEST
                    + " pictures a second, the film has " + framesPerSecond
                    + "; give the film fewer, or save it as .mp4 or as a folder of pictures");
        }
        try {
            if (this == GIF) {
                return new GifWriter(PendingFile.at(target, replace), framesPerSecond);
            }
            Path program = Mp4Writer.program(Objects.requireNonNullElse(System.getenv("PATH"), ""));
            return new Mp4Writer(program, PendingFile.at(target, replace), framesPerSecond);
        } catch (IOException e) {
            throw FileException.cannotWrite(target, e);
        }
    }
}
