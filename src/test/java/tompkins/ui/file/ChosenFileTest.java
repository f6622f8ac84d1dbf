package tompkins.ui.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.OnLinux;

class ChosenFileTest {

    @TempDir
    private Path folder;

    private Path inner;

    @BeforeEach
    void makeFolders() throws IOException {
        inner = Files.createDirectories(folder.resolve("outer/inner"));
    }

    @Test
    void detoursAreLeftOut() throws IOException {
        Path file = Files.createFile(folder.resolve("scene.json"));
        assertThat(ChosenFile.plain(inner.resolve("../.././scene.json"))).isEqualTo(file);
    }

    @Test
    @OnLinux
    void aDetourBehindALinkStays() throws IOException {
        Path file = Files.createFile(folder.resolve("outer/scene.json"));
        Files.createFile(folder.resolve("scene.json"));
        Path link = Files.createSymbolicLink(folder.resolve("link"), inner);

        Path named = ChosenFile.plain(link.resolve("../scene.json"));

        assertThat(Files.isSameFile(named, file)).isTrue();
    }

    @Test
    void whatIsNotThereKeepsItsName() {
        Path missing = inner.resolve("../missing.json");
        assertThat(ChosenFile.plain(missing)).isEqualTo(missing);
    }
}
