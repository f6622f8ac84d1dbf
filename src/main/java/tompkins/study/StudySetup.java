package tompkins.study;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
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

    /** The studios to be measured: the user's own, or else the named ones. */
    Map<String, Studio> studios(List<String> wanted) {
        Map<String, Studio> studios = new LinkedHashMap<>();
        if (scene != null) {
            studios.put("scene", scene);
        } else {
            wanted.forEach(name -> studios.put(name, bundled.apply(name)));
        }
        return studios;
    }
}
