package tompkins.file;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * A folder for files that are about to be written. It is made if there is none. If nothing has come into it, it is
 * removed when it is closed or the program is stopped.
 */
public final class OutputFolder implements Closeable {

    private final Path folder;
    private final boolean made;

    private OutputFolder(Path folder) throws IOException {
        this.folder = folder;
        made = !Files.isDirectory(folder);
        if (made) {
            // Java removes no folder that has something in it
            folder.toFile().deleteOnExit();
            Files.createDirectory(folder);
        }
    }

    /**
     * A folder of some name.
     *
     * @throws FileException if it cannot be made: there is no folder to put it in, no permission, or a file has its
     *     name
     */
    public static OutputFolder at(Path folder) throws FileException {
        try {
            Path above = folder.toAbsolutePath().getParent();
            if (above != null && !Files.isDirectory(above)) {
                throw new FileException(folder + ": cannot be written: there is no folder " + above);
            }
            if (Files.exists(folder) && !Files.isDirectory(folder)) {
                throw new FileException(folder + ": cannot be written: it is a file, not a folder");
            }
            return new OutputFolder(folder);
        } catch (IOException refused) {
            throw FileException.cannotWrite(folder, refused);
        }
    }

    /**
     * A folder of some name that has nothing in it yet; otherwise as {@link #at}.
     *
     * @throws FileException if there is something in it, or it cannot be made
     */
    public static OutputFolder emptyAt(Path folder) throws FileException {
        OutputFolder output = at(folder);
        try (Stream<Path> content = Files.list(folder)) {
            if (content.findAny().isPresent()) {
                throw new FileException(folder + ": cannot be written: it exists; name a new or an empty folder");
            }
        } catch (IOException refused) {
            throw FileException.cannotWrite(folder, refused);
        }
        return output;
    }

    @Override
    public void close() throws FileException {
        try {
            if (made && Files.isDirectory(folder)) {
                Files.delete(folder);
            }
        } catch (DirectoryNotEmptyException | NoSuchFileException used) {
            // as it should be
        } catch (IOException failure) {
            throw FileException.cannotWrite(folder, failure);
        }
    }
}
