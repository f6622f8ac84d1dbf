package tompkins.ui.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.OnLinux;
import tompkins.ui.widget.Look;

class SettingsTest {

    @TempDir
    private Path folder;

    private Settings settings() {
        return new Settings(folder.resolve("deep/window.properties"));
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

    /** Two windows with one folder, each of which knows only what it began with. */
    @Test
    void twoProgramsKeepWhatBothSet() {
        Settings first = settings();
        Settings second = settings();
        first.addRecentFile(folder.resolve("a.json"));
        second.addRecentFile(folder.resolve("b.json"));
        first.setNumber("width", 1000);
        first.addRecentFile(folder.resolve("c.json"));
        second.setLook(Look.DARK);
        assertThat(settings().recentFiles())
                .containsExactly(folder.resolve("c.json"), folder.resolve("b.json"), folder.resolve("a.json"));
        assertThat(second.recentFiles()).isEqualTo(settings().recentFiles());
        assertThat(settings().number("width", 1)).isEqualTo(1000);
        assertThat(settings().look()).isEqualTo(Look.DARK);
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

        assertThat(folder).isDirectoryNotContaining(path -> !path.equals(taken) && !path.endsWith("window.lock"));
        assertThat(taken.resolve("mine.txt")).hasContent("mine");
    }

    private static List<String> told(Settings settings) {
        List<String> told = new ArrayList<>();
        settings.tellTrouble(told::add);
        settings.setLook(Look.DARK);
        assertThat(settings.look()).isEqualTo(Look.DARK);
        return told;
    }

    @Test
    @OnLinux
    @Timeout(600)
    void whatIsNoFileIsToldOnceAndKept() throws Exception {
        Path pipe = folder.resolve("window.properties");
        assumeThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();

        assertThat(told(new Settings(pipe))).hasSize(1).first().asString().contains(pipe.toString());
        assertThat(Files.isRegularFile(pipe)).isFalse();
        Path file = Files.writeString(folder.resolve("file"), "");
        assertThat(told(new Settings(file.resolve("window.properties")))).hasSize(1);
        assertThat(told(new Settings(folder.resolve("new/window.properties")))).isEmpty();
    }

    @Test
    @OnLinux
    void onlyWhatCanBeAFileIsRecent() throws IOException {
        Path file = Files.writeString(
                folder.resolve("window.properties"), "recent.0=/\nrecent.1=\nrecent.2=/a/b.json\nrecent.3=\\u0000\n");

        assertThat(new Settings(file).recentFiles()).containsExactly(Path.of("/a/b.json"));
    }

    @Test
    @OnLinux
    void theFolderIsWhereItIsWanted() {
        Path home = Path.of("/home/me/.config/tompkins/window.properties");
        assertThat(found(null, null)).isEqualTo(home);
        assertThat(found(null, "/x")).isEqualTo(Path.of("/x/tompkins/window.properties"));
        assertThat(found(null, "")).isEqualTo(home);
        assertThat(found("mine", "/x")).isEqualTo(Path.of("mine/window.properties"));
        assertThat(found(null, "relative")).isEqualTo(home);
        assertThat(found("", null)).isEqualTo(home);
    }

    private static Path found(String property, String xdg) {
        Map<String, String> properties = new HashMap<>(Map.of("user.home", "/home/me"));
        properties.put("tompkins.settings", property);
        return Settings.file(properties::get, name -> name.equals("XDG_CONFIG_HOME") ? xdg : null);
    }
}
