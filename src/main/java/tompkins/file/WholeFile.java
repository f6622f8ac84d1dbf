package tompkins.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads the files that scenes use. They are read as a whole, and so must not be too large. */
public final class WholeFile {

    /** The most bytes that such a file may have. */
    public static final int LARGEST = 1 << 28;

    private WholeFile() {}

    /**
     * The bytes of a file.
     *
     * @throws IOException if they cannot be read, are too many, or may never end, like those of a device
     */
    public static byte[] read(Path file) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new FileException(file + ": not a file");
        }
        long size = Files.size(file);
        if (size > LARGEST) {
            throw new IOException("it has " + size + " bytes, and may have at most " + LARGEST);
        }
        return Files.readAllBytes(file);
    }
}
