package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import tompkins.file.FileException;

/**
 * An animation that is being saved frame by frame; only one frame is held in memory. It appears under its name with
 * {@link #finish}; if it is closed without that, it leaves no trace. For one thread at a time.
 *
 * <pre>{@code
 * try (AnimationWriter animation = AnimationFormat.GIF.open(file, 25, true)) {
 *     animation.add(frame, info);
 *     ...
 *     animation.finish();
 * }
 * }</pre>
 */
public abstract sealed class AnimationWriter implements Closeable permits GifWriter, Mp4Writer, NumberedPngWriter {

    private final Path target;

    /** Closed at the end; removes what is not complete. */
    private final Closeable unfinished;

    private int width;
    private int height;
    private int frames;
    private boolean ended;

    AnimationWriter(Path target, Closeable unfinished) {
        this.target = target;
        this.unfinished = unfinished;
    }

    /**
     * Adds a frame. All frames have the size of the first.
     *
     * @param frame as a screen shows it, of type {@link BufferedImage#TYPE_INT_RGB}
     * @param info what the frame says about itself, which numbered pictures keep; the other formats have no place for
     *     it
     * @throws FileException if the frame cannot be written; the animation is then closed
     * @throws IllegalArgumentException if the frame has another size than the first, or a size that the format does not
     *     allow
     * @throws IllegalStateException after {@link #finish} or {@link #close}
     */
    public final void add(BufferedImage frame, PhotographInfo info) throws FileException {
        requireOpen();
        if (frames == 0) {
            width = frame.getWidth();
            height = frame.getHeight();
        } else if (frame.getWidth() != width || frame.getHeight() != height) {
            throw new IllegalArgumentException("all frames must have the size of the first, " + width + " x " + height
                    + ", was " + frame.getWidth() + " x " + frame.getHeight());
        }
        try {
            write(frame, info, frames);
        } catch (IOException e) {
            throw givenUp(e);
        }
        frames++;
    }

    /**
     * Completes the animation and gives it its name.
     *
     * @return where it lies: under another name with a number, if its own was taken meanwhile and must not be replaced
     * @throws FileException if it cannot be written; it is then closed
     * @throws IllegalStateException if there is no frame, or after {@link #finish} or {@link #close}
     */
    public final Path finish() throws FileException {
        requireOpen();
        if (frames == 0) {
            throw new IllegalStateException("an animation must have a frame");
        }
        try {
            Path place = complete();
            close();
            return place;
        } catch (IOException e) {
            throw givenUp(e);
        }
    }

    /** Gives the animation up after a failure: half a frame may be in the file, so that nothing can be added. */
    private FileException givenUp(IOException cause) {
        FileException failure = FileException.cannotWrite(target, cause);
        try {
            close();
        } catch (FileException e) {
            failure.addSuppressed(e);
        }
        return failure;
    }

    /**
     * Gives up what is not finished and removes it, but for whole pictures in a folder; does nothing after
     * {@link #finish}.
     *
     * @throws FileException if it cannot be removed
     */
    @Override
    public final void close() throws FileException {
        ended = true;
        try {
            unfinished.close();
        } catch (IOException e) {
            throw FileException.cannotWrite(target, e);
        }
    }

    private void requireOpen() {
        if (ended) {
            throw new IllegalStateException("the animation is already finished or closed");
        }
    }

    /** Writes one frame; {@code index} counts from 0. */
    abstract void write(BufferedImage frame, PhotographInfo info, int index) throws IOException;

    /** Writes what comes after the last frame, closes all streams, and says where the animation lies. */
    abstract Path complete() throws IOException;
}
