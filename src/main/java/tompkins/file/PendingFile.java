package tompkins.file;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * An atomic write: the content goes into a hidden file beside its place, and {@link #commit} moves it there when it is
 * complete. {@link #close} without a commit removes it, and what was there before stays; the end of the program does
 * the same.
 */
public final class PendingFile implements Closeable {

    private static final int BUFFER = 1 << 16;

    /** Those that the end of the program, for instance by Ctrl-C, must not leave behind. */
    private static final Set<PendingFile> OPEN = ConcurrentHashMap.newKeySet();

    private static final AtomicBoolean STOPPED = new AtomicBoolean();

    static {
        Runtime.getRuntime().addShutdownHook(new Thread(PendingFile::closeAll, "tompkins-remove"));
    }

    private final boolean replaces;
    private final Path target;
    private final Path temporary;

    /** What writes here; closed before the file is removed, because it would go on writing. */
    private final List<Closeable> writers = new ArrayList<>();

    private boolean ended;

    private PendingFile(boolean replaces, Path target) throws IOException {
        this.replaces = replaces;
        this.target = target;
        Path folder = target.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new FileException(target + ": cannot be written: there is no folder " + folder);
        }
        requireName(target);
        temporary = folder.resolve(
                ".tompkins-" + Long.toHexString(ThreadLocalRandom.current().nextLong()) + ".part");
    }

    /**
     * A pending file that will have the name of {@code target}, or the same with a number if it replaces nothing and
     * something has that name when it is complete.
     *
     * @param replace whether it replaces what has its name, or what a link of that name points to
     * @throws IOException if there is no such folder, the name belongs to something that must not be replaced by a
     *     file, or nothing can be written there
     */
    public static PendingFile at(Path target, boolean replace) throws IOException {
        requireReplaceable(target);
        PendingFile pending = new PendingFile(replace, replace ? followed(target) : target);
        try {
            pending.create();
        } catch (IOException refused) {
            pending.close();
            throw refused;
        }
        return pending;
    }

    private synchronized void create() throws IOException {
        OPEN.add(this);
        ended = STOPPED.get();
        requireOpen();
        // Not Files.createTempFile, which hides from everybody but the owner.
        Files.createFile(temporary);
    }

    /** Ends all work at the end of the program; nothing new is begun then. */
    private static void closeAll() {
        STOPPED.set(true);
        for (PendingFile pending : OPEN) {
            try {
                pending.close();
            } catch (IOException | RuntimeException kept) {
                // there is nobody left to tell
            }
        }
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

    private static void requireReplaceable(Path target) throws IOException {
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

    /** Refuses a name that no file of the folder can have, such as one that is too long, before the work begins. */
    private static void requireName(Path target) throws IOException {
        try {
            Files.readAttributes(target, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
        } catch (NoSuchFileException free) {
            // as it should be
        }
    }

    /**
     * Refuses work on what is complete or was given up.
     *
     * @throws InterruptedIOException if it is, because the program is being stopped
     */
    public synchronized void requireOpen() throws InterruptedIOException {
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
        return new BufferedOutputStream(stopAtEnd(Files.newOutputStream(temporary)), BUFFER);
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
        Path place = replaces ? target : freeName();
        try {
            Files.move(temporary, place, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException failure) {
            if (!replaces) {
                Files.deleteIfExists(place);
            }
            throw failure;
        }
        close();
        return place;
    }

    /** Takes the first name that is free with an empty file, which only one program can make. */
    private Path freeName() throws IOException {
        String name = target.getFileName().toString();
        int dot = name.lastIndexOf('.') > 0 ? name.lastIndexOf('.') : name.length();
        Path free = target;
        for (int number = 2; ; number++) {
            try {
                return Files.createFile(free);
            } catch (FileAlreadyExistsException taken) {
                free = target.resolveSibling(name.substring(0, dot) + "-" + number + name.substring(dot));
            }
        }
    }

    /** Stops what writes here, and removes what was not committed. */
    @Override
    public synchronized void close() throws IOException {
        ended = true;
        OPEN.remove(this);
        for (Closeable writer : writers) {
            try {
                writer.close();
            } catch (IOException thrownAway) {
                // it need not be complete
            }
        }
        Files.deleteIfExists(temporary);
    }
}
