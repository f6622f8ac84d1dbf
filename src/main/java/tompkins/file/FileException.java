package tompkins.file;

import java.io.EOFException;
import java.io.IOException;
import java.util.zip.ZipException;
import javax.imageio.IIOException;
import tompkins.property.OneLine;

/**
 * A file could not be read or written. The message is one line: the file, the place in it, what is wrong, and what is
 * allowed.
 */
public final class FileException extends IOException {

    private static final long serialVersionUID = 1;

    /** Takes a complete message, and makes one line of it: names of files may hold control characters. */
    public FileException(String message) {
        super(OneLine.of(message));
    }

    /** As above, with the cause. */
    public FileException(String message, Throwable cause) {
        super(OneLine.of(message), cause);
    }

    /** The failure of writing a file or folder, in words. */
    public static FileException cannotWrite(Object file, IOException cause) {
        return wrap(file, "cannot be written", cause);
    }

    /** The failure of reading a file, or of a library that trusted it, in words. */
    public static FileException cannotRead(Object file, Exception cause) {
        return wrap(file, "cannot be read", cause);
    }

    private static FileException wrap(Object file, String problem, Exception cause) {
        if (cause instanceof FileException clear) {
            return clear;
        }
        return new FileException(file + ": " + problem + ": " + reason(cause), cause);
    }

    /**
     * What the innermost cause says, in one line. Memory that ran out says nothing about the file, though the libraries
     * make a failure to read of it, and is thrown on.
     */
    public static String reason(Throwable failure) {
        Throwable root = failure;
        while (root.getCause() != null) {
            root = root.getCause();
        }
        if (root instanceof OutOfMemoryError tooMuch) {
            throw tooMuch;
        }
        if (root instanceof RuntimeException
                || root instanceof EOFException
                || root instanceof ZipException
                || root instanceof IIOException) {
            // What a reader says about a damaged file is about the reader, not about the file.
            return "the file ends too early or contradicts itself";
        }
        return root instanceof IOException io ? FileFailure.reason(io) : root.toString();
    }
}
