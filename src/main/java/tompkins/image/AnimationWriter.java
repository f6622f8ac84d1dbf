package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import tompkins.file.FileException;
import tompkins.file.PendingFile;

/**
 * An animation that is being saved frame by frame; only one frame is held in memory. It appears under its name with
 * {@link #finish}; if it is closed without that, it leaves no trace. For one thread at a time.
 */
public abstract sealed class AnimationWriter implements Closeable permits GifWriter, Mp4Writer {

    /** Where it is written. */
    final PendingFile pending;

    private int frames;

    AnimationWriter(PendingFile pending) {
        this.pending = pending;
    }

    /**
     * Adds a frame. All frames have the size of the first.
     *
     * @param frame as a screen shows it, of type {@link BufferedImage#TYPE_INT_RGB}
     * @throws FileException if the frame cannot be written; the animation can then only be closed
     */
    public final void add(BufferedImage frame) throws FileException {
        try {
            write(frame, frames);
        } catch (IOException failure) {
            throw FileException.cannotWrite(pending, failure);
        }
        frames++;
    }

    /**
     * Completes the animation and gives it its name.
     *
     * @return where it lies: under another name with a number, if its own was taken meanwhile and must not be replaced
     * @throws FileException if it cannot be written
     */
    public final Path finish() throws FileException {
        try {
            complete();
            return pending.commit();
        } catch (IOException failure) {
            throw FileException.cannotWrite(pending, failure);
        }
    }

    /**
     * Gives up what is not finished and removes it; does nothing after {@link #finish}.
     *
     * @throws FileException if it cannot be removed
     */
    @Override
    public final void close() throws FileException {
        try {
            pending.close();
        } catch (IOException failure) {
            throw FileException.cannotWrite(pending, failure);
        }
    }

    /** Writes one frame; {@code index} counts from 0. */
    abstract void write(BufferedImage frame, int index) throws IOException;

    /** Writes what comes after the last frame, and closes all streams. */
    abstract void complete() throws IOException;
}
