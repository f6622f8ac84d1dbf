package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.MessageTable;
import tompkins.OnLinux;

/**
 * Every kind of bad input on the command line, and what the program says: that and no more, with exit code 2, and
 * nothing is written. In the table {@code @} is a folder, and what stands behind {@code <} is the text of a scene.
 */
@OnLinux
class BadInputTest {

    @TempDir
    private Path folder;

    @BeforeEach
    void writeFiles() throws IOException {
        write("good.json", "{ \"scene\": [{ \"type\": \"Sphere\" }] }");
        write("wall.json", """
                {
                  "settings": { "width": 101, "height": 101 },
                  "scene": [{ "type": "Plane", "point": [0, 0, 10], "normal": [0, 0, -1] }]
                }
                """);
        write("mine.png", "mine");
        write("text.png", "this is no picture");
        write("knot.obj", "f 1 2 3");
        Files.createDirectories(folder.resolve("folder.png"));
        Files.writeString(folder.resolve("utf16.json"), "{}", StandardCharsets.UTF_16);
        for (String name : List.of("tiff-zstd.tif", "tiff-int8.tif", "hdr-xyze.hdr")) {
            Files.copy(Path.of("src", "test", "resources", "pictures", name), folder.resolve(name));
        }
    }

    private Path write(String name, String text) {
        try {
            return Files.writeString(folder.resolve(name), text);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    @Test
    void everyBadInputGetsTheMessageOfTheTable() throws IOException {
        write("scene.json", "");
        List<Path> before = files();
        MessageTable.assertTold("tompkins/app/messages.txt", this::told, getClass());
        assertThat(files()).isEqualTo(before);
        assertThat(folder.resolve("mine.png")).hasContent("mine");
    }

    private String told(String line) {
        String[] parts = line.split(" < ", 2);
        if (parts.length > 1) {
            write("scene.json", parts[1]);
        }
        String command =
                parts[0].replaceAll("(?<= )@", folder + "/") + (parts.length > 1 ? " " + folder + "/scene.json" : "");
        ProgramRun run = ProgramRun.of((Object[]) command.split(" "));
        assertThat(run.out().isEmpty()).as(line).isEqualTo(run.code() != 0);
        String message = run.err().replace(folder + "/", "@").replace(folder.toString(), "@");
        return run.code() == Failures.MISTAKE ? message : message + "exit code " + run.code();
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.sorted().toList();
        }
    }
}
