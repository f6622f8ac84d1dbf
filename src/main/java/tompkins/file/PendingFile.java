package tompkins.file;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;

/**
 * A file that appears in its place only when it is complete. Until {@link #commit} it lies, under its own name, in a
 * folder of its own beside that place, so that a name that is not allowed is refused at once and not after the work.
 * {@link #close} without a commit removes every trace, and what was there before stays; the end of the program does the
 * same.
 */
public final class PendingFile implements Closeable {

    private static final int BUFFER = 1 << 16;

    private final boolean replaces;
    private final Path target;

    /** A folder beside that place, and what will be moved from it. */
    private final Path room;

    private final Path temporary;

    /**
     * What writes here and is not closed yet. It is stopped before the file is removed; otherwise it would go on
     * writing.
     */
    private final List<Closeable> writers = new ArrayList<>();

    private boolean ended;

    private PendingFile(boolean replaces, Path target, Path room) {
        this.replaces = replaces;
        this.target = target;
        this.room = room;
        temporary = room.resolve(target.getFileName());
    }

    /**
     * A pending file that will have the name of {@code target}, and replaces what has it. A link is followed: what it
     * points to is replaced.
     *
     * @throws IOException as {@link #requireReplaceable}, or if there is no such folder
     */
    public static PendingFile replacing(Path target) throws IOException {
        requireReplaceable(target);
        return beside(true, followed(target));
    }

    /**
     * A pending file that will have the name of {@code target}, or the same with a number if something has that name
     * when the file is complete.
     *
     * @throws IOException if there is no such folder, or nothing can be written there
     */
    public static PendingFile newFile(Path target) throws IOException {
        return beside(false, target);
    }

    /** A pending file that replaces what has its name, or one that replaces nothing. */
    public static PendingFile at(Path target, boolean replace) throws IOException {
        return replace ? replacing(target) : newFile(target);
    }

    /** Writes into a stream. */
    @FunctionalInterface
    public interface Content {

        /** Writes all that there is to write; the stream stays open. */
        void writeTo(OutputStream out) throws IOException;
    }

    /**
     * Writes a file that appears when it is complete.
     *
     * @param replace whether it replaces what has its name; otherwise it gets the same with a number if that is taken
     * @return where it lies
     * @throws FileException if it cannot be written
     */
    public static Path save(Path target, boolean replace, Content content) throws FileException {
        try (PendingFile pending = at(target, replace)) {
            try (OutputStream out = pending.open()) {
                content.writeTo(out);
            }
            return pending.commit();
        } catch (IOException failure) {
            throw FileException.cannotWrite(target, failure);
        }
    }

    /**
     * Refuses a name that belongs to something that must not be replaced by a file.
     *
     * @throws IOException if the name is that of a folder, a device, a pipe, or a file that is write-protected
     */
    public static void requireReplaceable(Path target) throws IOException {
        if (Files.isDirectory(target)) {
            throw new FileException(target + ": cannot be written: it is a folder; name a file in it");
        }
        if (Files.exists(target) && !Files.isRegularFile(target)) {
            throw new FileException(target + ": cannot be written: it is a device or a pipe, not a file");
        }
        if (Files.exists(target) && !Files.isWritable(target)) {
            throw new FileException(target + ": cannot be written: the file is write-protected");
        }
    }

    /** What a link points to; anything else stays as it is. */
    private static Path followed(Path target) throws IOException {
        if (!Files.isSymbolicLink(target)) {
            return target;
        }
        if (!Files.exists(target)) {
            throw new FileException(target + ": cannot be written: it is a link to nothing that exists");
        }
        return target.toRealPath();
    }

    private static PendingFile beside(boolean replaces, Path target) throws IOException {
        Path folder = target.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new FileException(target + ": cannot be written: there is no folder " + folder);
        }
        String name =
                ".tompkins-" + Long.toHexString(ThreadLocalRandom.current().nextLong()) + ".part";
        PendingFile pending = new PendingFile(replaces, target, folder.resolve(name));
        try {
            Unfinished.begin(pending);
            synchronized (pending) {
                pending.requireOpen();
                // Not Files.createTempDirectory nor createTempFile, which hide from everybody but the owner.
                Files.createDirectory(pending.room);
                Files.createFile(pending.temporary);
            }
        } catch (IOException refused) {
            pending.close();
            throw refused;
        }
        return pending;
    }

    /** Whether it is complete, was given up, or the program is being stopped. */
    public synchronized boolean isEnded() {
        return ended;
    }

    private void requireOpen() throws InterruptedIOException {
        if (ended) {
            throw new InterruptedIOException(FileFailure.STOPPED);
        }
    }

    /** Where it will lie. */
    @Override
    public String toString() {
        return target.toString();
    }

    /** Where other programs are to write the content; see {@link #stopAtEnd}. */
    public Path path() {
        return temporary;
    }

    /** A buffered stream into the pending file. */
    public synchronized OutputStream open() throws IOException {
        requireOpen();
        OutputStream stream = stopAtEnd(Files.newOutputStream(temporary));
        return new BufferedOutputStream(stream, BUFFER) {
            @Override
            public void close() throws IOException {
                super.close();
                closed(stream);
            }
        };
    }

    /** Writes all of the content. */
    public void write(byte[] content) throws IOException {
        try (OutputStream stream = open()) {
            stream.write(content);
        }
    }

    private synchronized void closed(Closeable writer) {
        writers.remove(writer);
    }

    /**
     * Registers something that writes here, and returns it. It is closed before the file is removed.
     *
     * @throws InterruptedIOException if that has happened already; it is then closed
     */
    public synchronized <C extends Closeable> C stopAtEnd(C writer) throws IOException {
        if (ended) {
            writer.close();
        }
        requireOpen();
        writers.add(writer);
        return writer;
    }

    /**
     * Gives the complete file its name; all streams into it must be closed. A new file replaces nothing: if its name
     * has been taken meanwhile, it gets the same with the first free number before its ending.
     *
     * @return where it lies now
     */
    public synchronized Path commit() throws IOException {
        requireOpen();
        // otherwise the name could outlive a power failure, and the content not
        try (FileChannel channel = FileChannel.open(temporary, StandardOpenOption.WRITE)) {
            channel.force(true);
        }
        Path place = replaces ? FileNames.replace(temporary, target) : FileNames.take(temporary, target);
        close();
        return place;
    }

    /** Stops what writes here, and removes what was not committed. */
    @Override
    public synchronized void close() throws IOException {
        ended = true;
        try {
            for (Closeable writer : writers) {
                try {
                    writer.close();
                } catch (IOException e) {
                    // it is thrown away, so it need not be complete
                }
            }
            writers.clear();
            // a name that is too long is in no folder, and cannot even be removed
            if (Files.exists(temporary)) {
                Files.delete(temporary);
            }
            Files.deleteIfExists(room);
        } finally {
            Unfinished.end(this);
        }
    }
}
