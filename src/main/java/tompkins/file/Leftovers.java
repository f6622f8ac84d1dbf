package tompkins.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;
import java.util.stream.Stream;

/**
 * The folders of unfinished files. They are removed when the program ends, unless it is killed or the power fails: then
 * the next run that writes beside them removes them.
 */
final class Leftovers {

    /** Work in which nothing has changed for so long is no longer done. */
    private static final Duration LONGEST_WORK = Duration.ofDays(1);

    private Leftovers() {}

    /** A name for the folder of an unfinished file, which no other has. */
    static String newName() {
        return ".tompkins-" + Long.toHexString(ThreadLocalRandom.current().nextLong()) + ".part";
    }

    /** Removes from a folder what earlier runs have left there, as far as that is allowed. */
    static void removeFrom(Path folder) {
        try (DirectoryStream<Path> rooms = Files.newDirectoryStream(folder, ".tompkins-*.part")) {
            for (Path room : rooms) {
                if (isLeft(room)) {
                    removeTree(room);
                }
            }
        } catch (IOException | UncheckedIOException | DirectoryIteratorException notAllowed) {
            // what the program is asked for can be done all the same; another process may also have removed a file
        }
    }

    private static boolean isLeft(Path room) throws IOException {
        if (!Files.isDirectory(room, LinkOption.NOFOLLOW_LINKS)) {
            return false;
        }
        Instant limit = Instant.now().minus(LONGEST_WORK);
        for (Path part : parts(room)) {
            if (Files.getLastModifiedTime(part, LinkOption.NOFOLLOW_LINKS)
                    .toInstant()
                    .isAfter(limit)) {
                return false;
            }
        }
        return true;
    }

    /** Removes a folder with all that is in it, if it is there. */
    static void removeTree(Path folder) throws IOException {
        if (Files.notExists(folder)) {
            return;
        }
        for (Path part : parts(folder)) {
            Files.deleteIfExists(part);
        }
    }

    /** A folder and all that is in it, what is inside before what it is in. */
    private static List<Path> parts(Path folder) throws IOException {
        try (Stream<Path> tree = Files.walk(folder)) {
            return tree.sorted(Comparator.reverseOrder()).toList();
        }
    }
}
