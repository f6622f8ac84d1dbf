package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.ui.widget.Look;

class SettingsTest {

    @TempDir
    private Path folder;

    private Settings settings() {
        return new Settings(folder.resolve("deep/window.properties"));
    }

    @Test
    void whatIsSetIsRemembered() {
        Settings first = settings();
        first.setLook(Look.PROJECTOR);
        first.setNumber("width", 1234);
        first.save();
        assertThat(settings().look()).isEqualTo(Look.PROJECTOR);
        assertThat(settings().number("width", 1)).isEqualTo(1234);
        assertThat(settings().number("height", 7)).isEqualTo(7);
    }

    @Test
    void theNewestFilesComeFirstAndOnce() {
        Settings settings = settings();
        for (int i = 0; i < 12; i++) {
            settings.addRecentFile(folder.resolve("scene" + i + ".json"));
        }
        settings.addRecentFile(folder.resolve("scene9.json"));
        assertThat(settings().recentFiles())
                .hasSize(8)
                .doesNotHaveDuplicates()
                .startsWith(folder.resolve("scene9.json"), folder.resolve("scene11.json"));
    }

    @Test
    void damagedSettingsAreAsIfThereWereNone() throws IOException {
        Files.createDirectories(folder.resolve("deep"));
        Files.writeString(folder.resolve("deep/window.properties"), "look=PURPLE\nwidth=wide\nbad=\\u00zz\n");
        assertThat(settings().look()).isEqualTo(Look.LIGHT);
        assertThat(settings().number("width", 5)).isEqualTo(5);
    }

    @Test
    void whatCannotBeSavedLeavesNothingBehind() throws IOException {
        Path taken = Files.createDirectory(folder.resolve("window.properties"));
        Files.writeString(taken.resolve("mine.txt"), "mine");

        new Settings(taken).setLook(Look.DARK);

        assertThat(folder).isDirectoryNotContaining(path -> !path.equals(taken));
        assertThat(taken.resolve("mine.txt")).hasContent("mine");
    }

    @Test
    void aFolderThatCannotBeWrittenIsNoTrouble() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "");
        Settings settings = new Settings(file.resolve("window.properties"));
        settings.setLook(Look.DARK);
        assertThat(settings.look()).isEqualTo(Look.DARK);
    }
}
