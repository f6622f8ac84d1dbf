package tompkins.study;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.zip.CRC32;
import tompkins.io.BundledScenes;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.studio.Studio;

/**
 * What a user chooses for a study.
 *
 * @param seed of everything that is random
 * @param scene the user's own scene, or null for those that come with the program
 */
public record StudySetup(long seed, Studio scene) {

    /** The name for a scene of the user, whatever the name of its file. */
    private static final String OWN = "scene";

    /**
     * The studios to be measured: the user's own, or else those that come with the program, in the order of their
     * names.
     *
     * @param wanted the names of those of the program, without ending; all if none is named
     */
    Map<String, Studio> studios(String... wanted) {
        if (scene != null) {
            return Map.of(OWN, scene);
        }
        Map<String, Studio> studios = new LinkedHashMap<>();
        try {
            for (Path file : BundledScenes.all()) {
                String name = file.getFileName().toString().replace(".json", "");
                if (wanted.length == 0 || List.of(wanted).contains(name)) {
                    studios.put(name, StudioReader.read(file));
                }
            }
        } catch (IOException missing) {
            throw new UncheckedIOException(missing);
        }
        return studios;
    }

    /**
     * The names of scenes, as settings give them: the name of the user's own scene comes with a digest, which changes
     * with the scene.
     */
    static String settings(Map<String, Studio> studios) {
        return studios.entrySet().stream()
                .map(entry -> entry.getKey().equals(OWN) ? OWN + " " + digest(entry.getValue()) : entry.getKey())
                .toList()
                .toString();
    }

    private static String digest(Studio studio) {
        CRC32 checksum = new CRC32();
        checksum.update(StudioWriter.writeComplete(studio).getBytes(StandardCharsets.UTF_8));
        return String.format(Locale.ROOT, "%08x", checksum.getValue());
    }
}
