package tompkins.app;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystemAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import tompkins.io.SceneFileException;
import tompkins.io.StudioReader;
import tompkins.studio.Studio;

/** The scenes that come with the program: in the folder {@code scenes}, or else inside the jar. */
final class BundledScenes {

    private static final Path FOLDER = Path.of("scenes");

    /** The topics that come first, for they show what the program is for; the others follow in the order of their files. */
    private static final List<String> FIRST_TOPICS = List.of("Figures of the paper", "Relativity");

    private BundledScenes() {}

    /** One scene file. */
    static Path file(String name) throws IOException {
        Path beside = FOLDER.resolve(name);
        return Files.exists(beside) ? beside : inside().resolve(name);
    }

    /** All scene files, by name. */
    static List<Path> all() throws IOException {
        Path folder = Files.isDirectory(FOLDER) ? FOLDER : inside();
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(".json"))
                    .sorted()
                    .toList();
        }
    }

    /** All scenes as a menu lists them, by topic and then by the names of their files; those that cannot be read are left out. */
    static List<Studio> studios() {
        try {
            return all().stream()
                    .flatMap(file -> read(file).stream())
                    .sorted(Comparator.comparingInt(BundledScenes::rank))
                    .toList();
        } catch (IOException missing) {
            return List.of();
        }
    }

    private static int rank(Studio scene) {
        int place = FIRST_TOPICS.indexOf(scene.topic());
        return place < 0 ? FIRST_TOPICS.size() : place;
    }

    private static Optional<Studio> read(Path file) {
        try {
            return Optional.of(StudioReader.read(file));
        } catch (SceneFileException broken) {
            return Optional.empty();
        }
    }

    private static Path inside() throws IOException {
        URL folder = BundledScenes.class.getResource("/scenes");
        if (folder == null) {
            throw new IOException(
                    "the program comes without its scenes: there is no folder scenes here nor in the jar");
        }
        try {
            URI uri = folder.toURI();
            if (uri.getScheme().equals("jar")) {
                try {
                    FileSystems.newFileSystem(uri, Map.of());
                } catch (FileSystemAlreadyExistsException opened) {
                    // opened before: Path.of finds it
                }
            }
            return Path.of(uri);
        } catch (URISyntaxException impossible) {
            throw new IOException("the folder of scenes has no usable name: " + folder, impossible);
        }
    }
}
