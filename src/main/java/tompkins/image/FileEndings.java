package tompkins.image;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import tompkins.file.FileException;

/** The endings of file names, such as {@code .png}; small and capital letters are the same. */
final class FileEndings {

    private FileEndings() {}

    static boolean match(Path file, List<String> endings) {
        String name = name(file).toLowerCase(Locale.ROOT);
        return endings.stream().anyMatch(name::endsWith);
    }

    /**
     * Refuses a file whose name has none of the endings, or is no more than an ending: many systems hide such files.
     */
    static void require(Path file, List<String> endings, String what) throws FileException {
        if (!match(file, endings)) {
            throw new FileException(file + ": the name of " + what + " must end in " + String.join(" or ", endings));
        }
        if (endings.contains(name(file).toLowerCase(Locale.ROOT))) {
            throw new FileException(file + ": the name of " + what + " is missing before the ending");
        }
    }

    private static String name(Path file) {
        Path last = file.getFileName();
        return last == null ? "" : last.toString();
    }
}
