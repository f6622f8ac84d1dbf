package tompkins.app;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import tompkins.file.FileException;
import tompkins.file.FileFailure;
import tompkins.property.MistakeException;

/**
 * Files as the user names them. A name that the locale cannot express is refused, because it would become another one.
 */
final class NamedFile {

    /** What Java makes of bytes that are no letters in the locale. */
    private static final String NO_LETTER = "\ufffd";

    private NamedFile() {}

    /**
     * A file of some name.
     *
     * @throws InvalidPathException if the name is empty, or the locale cannot express it or that of the current folder
     */
    static Path of(String name) {
        if (name.isEmpty()) {
            // Java would take it for the current folder
            throw new InvalidPathException(name, "empty");
        }
        Path file = Path.of(name);
        if (name.contains(NO_LETTER) && Files.notExists(file)) {
            throw new InvalidPathException(name, "no letters");
        }
        return file.isAbsolute() ? file : currentFolder().resolve(file);
    }

    /**
     * The current folder, as an empty path.
     *
     * @throws InvalidPathException if the locale cannot express its name: Java would look elsewhere
     */
    static Path currentFolder() {
        String name = System.getProperty("user.dir");
        if (name.contains(NO_LETTER)) {
            throw new InvalidPathException(name, "no letters");
        }
        return Path.of("");
    }

    /** Uses a file or folder. */
    interface Use<T> {

        T make() throws FileException;
    }

    /** Uses what the user named. What fails then is no failure of the disk but a mistake: the user named the place. */
    static <T> T used(Use<T> use) {
        try {
            return use.make();
        } catch (FileException wrongPlace) {
            throw new MistakeException(wrongPlace.getMessage());
        }
    }

    /**
     * Refuses a name for a file to be written that others would take for a file of another kind.
     *
     * @param what what the file is
     * @param endings those that its name may have, in small or capital letters; the usual one first
     */
    static void requireEnding(Path file, String what, String... endings) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        if (Arrays.stream(endings).noneMatch(name::endsWith)) {
            throw new MistakeException(file + ": the name of a " + what + " must end in " + endings[0]);
        }
    }

    /** What is wrong with a name. */
    static String mistake(InvalidPathException refused) {
        String name = refused.getInput();
        return (name.isEmpty() ? "\"\"" : name) + ": " + FileFailure.reason(refused);
    }
}
