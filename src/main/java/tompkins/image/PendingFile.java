package tompkins.image;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;

/**
 * A file, or a folder of files, that appears in its place only when it is complete. Until {@link #commit} it lies,
 * under its own name, in a folder of its own beside that place: a name that cannot be had is refused at once, not after
 * the work. {@link #close} without it removes every trace, and what was there before stays.
 */
public final class PendingFile implements Closeable {

    /** What is not closed yet: when the program is stopped in the middle, nobody else removes it. */
    private static final Set<PendingFile> OPEN = new HashSet<>();

    /** Whether the program is being stopped; from then on nothing is begun. */
    private static final AtomicBoolean STOPPED = new AtomicBoolean();

    static {
        Runtime.getRuntime().addShutdownHook(new Thread(PendingFile::removeAll, "tompkins-remove"));
    }

    private final Path target;
    private final Path room;
    private final Path temporary;

    private PendingFile(Path target, Path room) {
        this.target = target;
        this.room = room;
        temporary = room.resolve(target.getFileName());
    }

    /**
     * A pending file that will have the name of {@code target}. A link is followed: what it points to is replaced.
     *
     * @throws IOException if there is no such folder, something that must not be replaced has the name, or it is a link
     *     to a file of another kind
     */
    public static PendingFile file(Path target) throws IOException {
        if (Files.isDirectory(target)) {
            throw new FileException(target + ": cannot be written: it is a folder; name a file in it");
        }
        if (Files.exists(target) && !Files.isWritable(target)) {
            throw new FileException(target + ": cannot be written: the file is write-protected");
        }
        Path place = followed(target);
        if (Files.isSymbolicLink(target)) {
            requireSameKind(target, place);
        }
        return beside(place, false);
    }

    /** What a link points to; what is no link stays as it is. */
    private static Path followed(Path target) throws IOException {
        if (!Files.isSymbolicLink(target)) {
            return target;
        }
        if (!Files.exists(target)) {
            throw new FileException(target + ": cannot be written: it is a link to nothing that exists");
        }
        return target.toRealPath();
    }

    private static void requireSameKind(Path link, Path place) throws IOException {
        if (!ending(place).equals(ending(link))) {
            throw new FileException(link + ": cannot be written: it is a link to " + place
                    + ", a file of another kind, which would be lost");
        }
    }

    private static String ending(Path file) {
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /**
     * A pending folder that will have the name of {@code target}. A link is followed: the empty folder that it points
     * to is replaced.
     *
     * @throws IOException if there is no such folder to put it in, a file or a folder with content has the name, or it
     *     is a link to nothing
     */
    static PendingFile folder(Path target) throws IOException {
        if (Files.exists(target) && !isEmptyFolder(target)) {
            throw new FileException(target + ": cannot be written: it exists; name a new or an empty folder");
        }
        return beside(followed(target), true);
    }

    private static PendingFile beside(Path target, boolean isFolder) throws IOException {
        Path folder = target.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new FileException(target + ": cannot be written: there is no folder " + folder);
        }
        PendingFile pending = new PendingFile(target, folder.resolve(".tompkins-" + UUID.randomUUID() + ".part"));
        try {
            pending.begin(isFolder);
        } catch (IOException refused) {
            pending.close();
            throw refused;
        }
        return pending;
    }

    private void begin(boolean isFolder) throws IOException {
        synchronized (OPEN) {
            if (STOPPED.get()) {
                throw new InterruptedIOException("the program is being stopped");
            }
            OPEN.add(this);
            // Not Files.createTempDirectory nor createTempFile, which hide from everybody but the owner.
            Files.createDirectory(room);
            if (isFolder) {
                Files.createDirectory(temporary);
            } else {
                Files.createFile(temporary);
            }
        }
    }

    private static boolean isEmptyFolder(Path path) throws IOException {
        if (!Files.isDirectory(path)) {
            return false;
        }
        try (Stream<Path> content = Files.list(path)) {
            return content.findAny().isEmpty();
        }
    }

    /** Where the content is to be written. */
    public Path path() {
        return temporary;
    }

    /** A buffered stream into the pending file. */
    OutputStream open() throws IOException {
        return new BufferedOutputStream(Files.newOutputStream(temporary, StandardOpenOption.WRITE), 1 << 16);
    }

    /** Gives the complete file its name; all streams into it must be closed. */
    public void commit() throws IOException {
        synchronized (OPEN) {
            if (Files.isDirectory(temporary)) {
                // Not every system replaces a folder, even an empty one.
                Files.deleteIfExists(target);
            }
            try {
                Files.move(temporary, target, StandardCopyOption.ATOMIC_MOVE);
            } catch (AtomicMoveNotSupportedException e) {
                Files.move(temporary, target, StandardCopyOption.REPLACE_EXISTING);
            }
            remove();
        }
    }

    private static void removeAll() {
        synchronized (OPEN) {
            STOPPED.set(true);
            for (PendingFile pending : List.copyOf(OPEN)) {
                try {
                    pending.remove();
                } catch (IOException | UncheckedIOException kept) {
                    // there is nobody left to tell
                }
            }
        }
    }

    /** Removes what was not committed. */
    @Override
    public void close() throws IOException {
        synchronized (OPEN) {
            remove();
        }
    }

    /** Whoever calls this holds the lock: the program must not end in the middle of it. */
    private void remove() throws IOException {
        OPEN.remove(this);
        if (Files.notExists(room)) {
            return;
        }
        List<Path> parts;
        try (Stream<Path> tree = Files.walk(room)) {
            parts = tree.sorted(Comparator.reverseOrder()).toList();
        }
        for (Path part : parts) {
            Files.deleteIfExists(part);
        }
    }
}
