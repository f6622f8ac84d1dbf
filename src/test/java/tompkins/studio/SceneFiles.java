package tompkins.studio;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import tompkins.io.StudioReader;

/** The scene files that come with the program. */
public final class SceneFiles {

    private static final Path FOLDER = Path.of(System.getProperty("basedir", ""), "scenes");

    private SceneFiles() {}

    /** All of them, in the order of their names. */
    public static Stream<Named<Studio>> all() {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".json")).sorted().toList().stream()
                    .map(file -> Named.of(file.getFileName().toString(), StudioReader.read(file)));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
