package tompkins.file;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;

/**
 * A folder for files that are about to be written. It is made if there is none. If nothing has come into it, it is
 * removed when it is closed or the program is stopped.
 */
public final class OutputFolder implements Closeable {

    private final Path folder;
    private boolean made;

    private OutputFolder(Path folder) {
        this.folder = folder;
    }

    /**
     * A folder of some name.
     *
     * @throws FileException if it cannot be made: there is no folder to put it in, no permission, or a file has its
     *     name
     */
    public static OutputFolder at(Path folder) throws FileException {
        OutputFolder output = new OutputFolder(folder);
        try {
            output.make();
        } catch (IOException refused) {
            throw FileException.cannotWrite(folder, refused);
        }
        return output;
    }

    private synchronized void make() throws IOException {
        Path above = folder.toAbsolutePath().getParent();
        if (above != null && !Files.isDirectory(above)) {
            throw new FileException(folder + ": cannot be written: there is no folder " + above);
        }
        if (Files.isDirectory(folder)) {
            return;
        }
        Unfinished.begin(this);
        try {
            Files.createDirectory(folder);
            made = true;
        } catch (IOException refused) {
            Unfinished.end(this);
            if (!(refused instanceof FileAlreadyExistsException)) {
                throw refused;
            }
            if (!Files.isDirectory(folder)) {
                throw new FileException(folder + ": cannot be written: it is a file, not a folder");
            }
        }
    }

    @Override
    public synchronized void close() throws FileException {
        if (!made) {
            return;
        }
        made = false;
        try {
            if (Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
                Files.delete(folder);
            }
        } catch (DirectoryNotEmptyException used) {
            // as it should be
        } catch (IOException failure) {
            throw FileException.cannotWrite(folder, failure);
        } finally {
            Unfinished.end(this);
        }
    }
}
