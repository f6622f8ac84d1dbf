package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Hidden;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.DescribedTypes;
import tompkins.studio.Studio;
import tompkins.surface.Surface;

class BundledScenesTest {

    @Test
    void theFirstSceneIsThatOfItsFile() throws IOException {
        assertThat(BundledScenes.firstStudio()).isEqualTo(StudioReader.read(BundledScenes.first()));
        assertThat(BundledScenes.firstStudio().title()).startsWith("A town square");
    }

    /** The window opens such links, wherever it runs. */
    @Test
    void scenesOfTheDocumentsAreThere() throws IOException {
        Pattern link = Pattern.compile("\\(\\.\\./scenes/([^)]+\\.json)\\)");
        String tour = Files.readString(Path.of(System.getProperty("basedir", ""), "docs", "tour.md"));
        List<String> names =
                link.matcher(tour).results().map(found -> found.group(1)).toList();
        assertThat(names).contains("whole-sky.json");
        for (String name : names) {
            assertThat(BundledScenes.studio(name).title()).as(name).isNotEmpty();
        }
    }

    /** All but what cannot be seen; shutters are exchanged in the window, and have no scenes of their own. */
    @Test
    void everyObjectAndSurfaceIsShownByAScene() throws IOException {
        Set<Class<?>> shown = DescribedTypes.in(BundledScenes.studios().stream());
        assertThat(Stream.of(SceneObject.class, Surface.class)
                        .flatMap(family -> Descriptions.members(family).stream())
                        .filter(type -> type != Hidden.class && !shown.contains(type)))
                .as("a scene with each is to be added to scenes/")
                .isEmpty();
    }

    @Test
    void topicsThatMatterMostComeFirst() throws IOException {
        List<Studio> scenes = BundledScenes.studios();
        assertThat(scenes).hasSameSizeAs(BundledScenes.all());
        List<String> topics = scenes.stream().map(Studio::topic).toList();
        assertThat(topics.stream().distinct())
                .containsExactly(
                        "Rides",
                        "Courtial et al. 2016",
                        "Relativity",
                        "Motion",
                        "Light in flight",
                        "Stars",
                        "Lessons",
                        "Objects",
                        "Shutters",
                        "Surfaces");
        for (int i = 1; i < topics.size(); i++) {
            assertThat(topics.get(i).equals(topics.get(i - 1))
                            || !topics.subList(0, i).contains(topics.get(i)))
                    .as("scenes of one topic stand together: %s", scenes.get(i).title())
                    .isTrue();
        }
        assertThat(scenes.stream().map(Studio::title))
                .startsWith(
                        "A town square at 0.8 c",
                        "A ride: between columns",
                        "To Alpha Centauri with 1 g",
                        "Fig. 1(a): camera at rest");
    }
}
