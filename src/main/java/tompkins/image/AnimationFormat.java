package tompkins.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The formats in which animations are saved. They play forever if the format can say so. */
public enum AnimationFormat {

    /** Animated PNG: exact. The scene of the first frame travels inside. */
    APNG("an animated PNG", List.of(".png", ".apng")),

    /** Animated GIF: at most 256 colours a frame, delays in hundredths of a second and not below two of them. */
    GIF("an animated GIF", List.of(".gif")),

    /** H.264 video, made by the program ffmpeg where it is installed; not exact. */
    MP4("an MP4 video", List.of(".mp4")),

    /**
     * A folder of PNG pictures {@code frame0001.png}, {@code frame0002.png}, ..., each with its scene inside: exact.
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
            String known = Stream.of(values())
                    .flatMap(format -> format.endings.stream())
                    .collect(Collectors.joining(", "));
            throw new FileException(target + ": the name of an animation must end in one of " + known
                    + ", or have no ending, for a folder of numbered PNG pictures");
        }
        return NUMBERED_PNG;
    }

    /**
     * Begins an animation that replaces the file that has its name, if there is one.
     *
     * @param target the file, or for numbered pictures the folder, which must be new or empty
     * @param framesPerSecond from 1 to {@link #FASTEST}
     * @throws FileException if the name does not fit the format, nothing can be written there, or ffmpeg is missing
     * @throws IllegalArgumentException if {@code framesPerSecond} is out of range
     */
    public AnimationWriter open(Path target, int framesPerSecond) throws FileException {
        return open(target, framesPerSecond, PendingFile::replacing);
    }

    /**
     * Begins an animation that replaces nothing: if its name is taken when it is complete, it gets a name with a
     * number. Otherwise as {@link #open}.
     */
    public AnimationWriter openNew(Path target, int framesPerSecond) throws FileException {
        return open(target, framesPerSecond, file -> {
            PendingFile.requireReplaceable(file);
            return PendingFile.newFile(file);
        });
    }

    /** Begins a file. */
    private interface Beginning {

        PendingFile begin(Path target) throws IOException;
    }

    private AnimationWriter open(Path target, int framesPerSecond, Beginning file) throws FileException {
        if (framesPerSecond < 1 || framesPerSecond > FASTEST) {
            throw new IllegalArgumentException(
                    "framesPerSecond must be a whole number from 1 to " + FASTEST + ", was " + framesPerSecond);
        }
        if (!endings.isEmpty()) {
            FileEndings.require(target, endings, description);
        }
        try {
            return switch (this) {
                case APNG -> new ApngWriter(file.begin(target), framesPerSecond);
                case GIF -> new GifWriter(file.begin(target), framesPerSecond);
                case MP4 -> {
                    Path program = Mp4Writer.program();
                    yield new Mp4Writer(file.begin(target), framesPerSecond, program);
                }
                case NUMBERED_PNG -> new NumberedPngWriter(PendingFile.newFolder(target));
            };
        } catch (IOException e) {
            throw FileException.cannotWrite(target, e);
        }
    }
}
