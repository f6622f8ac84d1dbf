package tompkins.file;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.ClosedChannelException;
import java.nio.charset.Charset;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Says in words why a file cannot be read or written. */
public final class FileFailure {

    /** What is said if the end of the program interrupts the work. */
    public static final String STOPPED = "the program is being stopped";

    private FileFailure() {}

    /** Why no file can have a name; often the locale is at fault, not the name. */
    public static String reason(InvalidPathException failure) {
        String encoding = System.getProperty("sun.jnu.encoding", "");
        String name = failure.getInput();
        if (encoding.equals("UTF-8") && name.contains("\ufffd")) {
            return "the bytes of this name are no letters in UTF-8, the encoding of the locale; rename it";
        }
        boolean isNameAtFault = name.indexOf('\0') >= 0
                || encoding.equals("UTF-8")
                || !Charset.isSupported(encoding)
                || Charset.forName(encoding).newEncoder().canEncode(name);
        return isNameAtFault
                ? "no file can have this name"
                : "the locale has no such letters for the names of files (it has " + encoding
                        + "); set one with UTF-8, such as LC_ALL=C.UTF-8, and start the program again";
    }

    /**
     * A hint at what has the name of a missing file, or of its folder, but for capital letters; empty if there is
     * nothing.
     */
    public static String otherCase(Path missing) {
        Path folder = missing.toAbsolutePath().getParent();
        if (folder == null) {
            return "";
        }
        if (!Files.isDirectory(folder)) {
            return otherCase(folder);
        }
        String name = missing.getFileName().toString();
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name::equalsIgnoreCase)
                    .sorted()
                    .map(other -> ", but there is " + other)
                    .collect(Collectors.joining());
        } catch (IOException | UncheckedIOException unreadable) {
            return "";
        }
    }

    /** The reason in a few words and one line, without the name of the file. */
    public static String reason(IOException failure) {
        if (failure instanceof NoSuchFileException missing) {
            return "there is no such file or folder" + otherCase(Path.of(missing.getFile()));
        }
        if (failure instanceof FileNotFoundException) {
            return "there is no such file or folder";
        }
        if (failure instanceof AccessDeniedException) {
            return "there is no permission";
        }
        if (failure instanceof FileAlreadyExistsException) {
            return "there is a file of this name already";
        }
        if (failure instanceof NotDirectoryException) {
            return "it is a file, not a folder";
        }
        if (failure instanceof ClosedChannelException) {
            // nothing else closes a file while it is written
            return STOPPED;
        }
        String message = failure instanceof FileSystemException system && system.getReason() != null
                ? system.getReason()
                : failure.getMessage();
        return message == null || message.isBlank()
                ? failure.getClass().getSimpleName()
                : message.strip().lines().findFirst().orElseThrow();
    }
}
