package tompkins.ui.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.io.StudioWriter;
import tompkins.studio.Studio;
import tompkins.studio.Studios;

class LossTest {

    private static final Studio HELD = Studios.sphere();

    @TempDir
    private Path folder;

    private Loss of(String text) throws IOException {
        return Loss.of(Files.writeString(folder.resolve("scene.json"), text), HELD);
    }

    @Test
    void onlyWhatSomebodyWroteIsLost() throws IOException {
        String written = StudioWriter.write(HELD, folder.resolve("scene.json"));
        assertThat(of(written)).isEqualTo(Loss.NOTHING);
        assertThat(of(written.replace("\n", "\r\n"))).isEqualTo(Loss.NOTHING);
        assertThat(of("// mine\n" + written)).isEqualTo(Loss.HANDWRITING);
        assertThat(of(StudioWriter.write(Studios.lattice(), folder.resolve("scene.json"))))
                .isEqualTo(Loss.OTHER_SCENE);
        assertThat(of("no scene")).isEqualTo(Loss.OTHER_SCENE);
        assertThat(Loss.of(folder.resolve("gone.json"), HELD)).isEqualTo(Loss.NOTHING);
    }
}
