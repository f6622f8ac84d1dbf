package tompkins.file;

import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/**
 * Gives a complete file its name, in the same file system. Taking a name also checks that it is free, so that neither
 * of two programs that want one name loses what it has made.
 */
final class FileNames {

    private FileNames() {}

    /** Replaces what has a name. */
    static Path replace(Path complete, Path name) throws IOException {
        try {
            Files.move(complete, name, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException | FileAlreadyExistsException e) {
            Files.move(complete, name, StandardCopyOption.REPLACE_EXISTING);
        }
        return name;
    }

    /** Takes a name; if it is not free, takes the same with the first free number before its ending. */
    static Path take(Path complete, Path wanted) throws IOException {
        Path name = wanted;
        for (int number = 2; !takes(complete, name); number++) {
            name = numbered(wanted, number);
        }
        return name;
    }

    /** The name with a number before its ending. */
    private static Path numbered(Path file, int number) {
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        int end = dot > 0 ? dot : name.length();
        return file.resolveSibling(name.substring(0, end) + "-" + number + name.substring(end));
    }

    /** Tries to take a name with an empty file, which only one program can make. */
    private static boolean takes(Path complete, Path name) throws IOException {
        try {
            Files.createFile(name);
        } catch (FileAlreadyExistsException taken) {
            return false;
        }
        try {
            replace(complete, name);
        } catch (IOException failure) {
            Files.deleteIfExists(name);
            throw failure;
        }
        return true;
    }
}
