package tompkins.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Stream;
import tompkins.file.FileException;
import tompkins.file.FileFailure;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.property.MistakeException;
import tompkins.studio.Studio;

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
     * @throws MistakeException if the name is empty, or the locale cannot express it or that of the current folder
     */
    static Path of(String name) {
        try {
            Path file = Path.of(name);
            // Java would take no name for the current folder
            if (name.isEmpty() || name.contains(NO_LETTER) && Files.notExists(file)) {
                throw new InvalidPathException(name, "no name");
            }
            return file.isAbsolute() ? file : currentFolder().resolve(file);
        } catch (InvalidPathException refused) {
            throw new MistakeException(OptionValues.shown(refused.getInput()) + ": " + FileFailure.reason(refused));
        }
    }

    /**
     * The current folder, as an empty path.
     *
     * @throws MistakeException if the locale cannot express its name: Java would look elsewhere
     */
    static Path currentFolder() {
        String name = System.getProperty("user.dir");
        if (name.contains(NO_LETTER)) {
            throw new MistakeException(name + ": " + FileFailure.reason(new InvalidPathException(name, "no letters")));
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

    /** The files of a scene: its own, unless it is the standard input, and its pictures and meshes. */
    static Stream<Path> ofScene(Studio studio, Path scene) {
        Stream<Path> own = scene.equals(StudioReader.PIPE) ? Stream.empty() : Stream.of(scene);
        // names inside of the scene are looked for only if there is a file to be replaced
        return Stream.concat(
                own,
                Stream.of(studio)
                        .flatMap(each -> StudioWriter.files(each).stream().map(scene::resolveSibling)));
    }

    /** Refuses to write over a file that the command reads: it would be lost. This cannot be forced. */
    static void requireNotRead(Path target, Stream<Path> read) {
        if (Files.exists(target) && read.anyMatch(file -> isSame(file, target))) {
            throw new MistakeException(target + ": the command reads this file and does not replace it, not even with"
                    + " --force; name another file");
        }
    }

    private static boolean isSame(Path file, Path other) {
        try {
            return Files.isSameFile(file, other);
        } catch (IOException noSuchFile) {
            return false;
        }
    }
}
