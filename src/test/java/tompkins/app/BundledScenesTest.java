package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import tompkins.io.StudioReader;
import tompkins.studio.Studio;

class BundledScenesTest {

    @Test
    void theFirstSceneIsThatOfItsFile() throws IOException {
        assertThat(BundledScenes.firstStudio()).isEqualTo(StudioReader.read(BundledScenes.first()));
        assertThat(BundledScenes.firstStudio().title()).startsWith("Fig. 1(b)");
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
