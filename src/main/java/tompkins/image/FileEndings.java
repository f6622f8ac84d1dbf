package tompkins.image;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** The endings of file names, such as {@code .png}; small and capital letters are the same. */
final class FileEndings {

    private FileEndings() {}

    static boolean match(Path file, List<String> endings) {
        String name = name(file).toLowerCase(Locale.ROOT);
        return endings.stream().anyMatch(name::endsWith);
    }

    /** Refuses a file whose name has none of the endings. */
    static void require(Path file, List<String> endings, String what) throws PictureException {
        if (!match(file, endings)) {
            throw new PictureException(file + ": the name of " + what + " must end in " + String.join(" or ", endings));
        }
    }

    private static String name(Path file) {
        Path last = file.getFileName();
        return last == null ? "" : last.toString();
    }
}
