package tompkins.io;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import tompkins.property.MistakeException;
import tompkins.studio.Studio;

/** The scenes that come with the program, inside the jar. */
public final class BundledScenes {

    private static final String FOLDER = "/scenes/";
    private static final String FIRST = "town-square.json";

    /**
     * The topics that come first because they show what the program is for; the others follow in alphabetical order.
     */
    private static final List<String> FIRST_TOPICS =
            List.of("Rides", "Courtial et al. 2016", "Relativity", "Motion", "Light in flight", "Stars");

    private BundledScenes() {}

    /**
     * The file of the scene that is taken if no other is named.
     *
     * @throws IOException if the program comes without its scenes
     */
    public static Path first() throws IOException {
        return file(FIRST);
    }

    /**
     * That scene, read without the file system of the jar, which takes long to open.
     *
     * @throws IOException if the program comes without its scenes
     */
    public static Studio firstStudio() throws IOException {
        try (InputStream in = inside(FIRST).openStream()) {
            return StudioReader.read(new String(in.readAllBytes(), StandardCharsets.UTF_8), FIRST, Path.of(""));
        }
    }

    /**
     * One scene.
     *
     * @param name the name of its file
     * @throws IOException if the program comes without its scenes
     * @throws MistakeException if there is no scene of this name
     */
    public static Studio studio(String name) throws IOException {
        return StudioReader.read(file(name));
    }

    private static Path file(String name) throws IOException {
        return folder().resolve(name);
    }

    /**
     * All scene files, by name.
     *
     * @throws IOException if the program comes without its scenes
     */
    public static List<Path> all() throws IOException {
        try (Stream<Path> files = Files.list(folder())) {
            return files.filter(file -> file.toString().endsWith(".json"))
                    .sorted()
                    .toList();
        }
    }

    /**
     * Some scenes, or all, in the order of the names of their files.
     *
     * @param wanted names without ending; all scenes if none is named
     * @throws UncheckedIOException if the program comes without its scenes
     */
    public static Map<String, Studio> named(String... wanted) {
        Map<String, Studio> scenes = new LinkedHashMap<>();
        try {
            for (Path file : all()) {
                String name = file.getFileName().toString().replace(".json", "");
                if (wanted.length == 0 || List.of(wanted).contains(name)) {
                    scenes.put(name, StudioReader.read(file));
                }
            }
        } catch (IOException missing) {
            throw new UncheckedIOException(missing);
        }
        return scenes;
    }

    /**
     * All scenes as a menu lists them, by topic and then by the names of their files, the first scene of the program
     * before them; those that cannot be read are left out.
     */
    public static List<Studio> studios() {
        try {
            return all().stream()
                    .sorted(Comparator.comparing(file -> !file.endsWith(FIRST)))
                    .flatMap(file -> read(file).stream())
                    .sorted(Comparator.comparingInt(BundledScenes::rank).thenComparing(Studio::topic))
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
        } catch (MistakeException broken) {
            return Optional.empty();
        }
    }

    private static Path folder() throws IOException {
        try {
            URI uri = inside("").toURI();
            if (uri.getScheme().equals("jar")) {
                try {
                    FileSystems.newFileSystem(uri, Map.of());
                } catch (FileSystemAlreadyExistsException opened) {
                    // opened before; Path.of finds it
                }
            }
            return Path.of(uri);
        } catch (URISyntaxException impossible) {
            throw new IOException("the folder of scenes has no usable name", impossible);
        }
    }

    private static URL inside(String name) throws IOException {
        URL place = BundledScenes.class.getResource(FOLDER + name);
        if (place == null) {
            throw new IOException("the program comes without its scenes");
        }
        return place;
    }
}
