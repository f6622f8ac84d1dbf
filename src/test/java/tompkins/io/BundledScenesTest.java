package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import tompkins.studio.Studio;

class BundledScenesTest {

    @Test
    void theFirstSceneIsThatOfItsFile() throws IOException {
        assertThat(BundledScenes.firstStudio()).isEqualTo(StudioReader.read(BundledScenes.first()));
        assertThat(BundledScenes.firstStudio().title()).startsWith("Fig. 1(b)");
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

    @Test
    void topicsThatMatterMostComeFirst() throws IOException {
        List<Studio> scenes = BundledScenes.studios();
        assertThat(scenes).hasSameSizeAs(BundledScenes.all());
        assertThat(scenes.stream().map(Studio::topic).distinct())
                .containsExactly("Figures of the paper", "Relativity", "Objects", "Surfaces");
        assertThat(scenes.stream().map(Studio::title)).startsWith("Fig. 1(a): camera at rest");
    }
}
