package tompkins.study;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.zip.CRC32;
import tompkins.io.StudioWriter;
import tompkins.studio.Studio;

/**
 * What a user chooses for a study.
 *
 * @param seed of everything that is random
 * @param scene the user's own scene, or null for those that come with the program
 * @param bundled the scenes that come with the program, by name without ending
 * @param names the names of all of them
 */
public record StudySetup(long seed, Studio scene, Function<String, Studio> bundled, List<String> names) {

    /** The name for a scene of the user, whatever the name of its file. */
    private static final String OWN = "scene";

    /** The studios to be measured: the user's own, or else the named ones. */
    Map<String, Studio> studios(List<String> wanted) {
        Map<String, Studio> studios = new LinkedHashMap<>();
        if (scene != null) {
            studios.put(OWN, scene);
        } else {
            wanted.forEach(name -> studios.put(name, bundled.apply(name)));
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
