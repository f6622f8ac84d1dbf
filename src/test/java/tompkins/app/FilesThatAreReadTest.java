package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.OnLinux;

/** No command writes over what it reads, not even with {@code --force}. */
class FilesThatAreReadTest {

    @TempDir
    private Path folder;

    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("wall.html"), """
                {
                  "settings": { "width": 8, "height": 6 },
                  "scene": [{ "type": "TriangleMesh", "mesh": "wall.obj" }]
                }
                """);
        Files.writeString(folder.resolve("wall.obj"), "v -1 -1 5\nv 1 -1 5\nv 0 1 5\nf 1 2 3\n");
    }

    private static void requireKept(Path file, Object... command) throws IOException {
        byte[] before = Files.readAllBytes(file);
        List<Object> words = new ArrayList<>(List.of(command));
        words.add("--force");

        ProgramRun run = ProgramRun.of(words.toArray());

        assertThat(run.err())
                .isEqualToIgnoringNewLines(file + ": the command reads this file and does not replace it, not even with"
                        + " --force; name another file");
        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(Files.readAllBytes(file)).isEqualTo(before);
    }

    private static Object[] append(Object[] words, Object... more) {
        return Stream.of(words, more).flatMap(Stream::of).toArray();
    }

    private Path photograph(String name) {
        Path file = folder.resolve(name);
        ProgramRun run = ProgramRun.of("render", scene, "-o", file);
        assertThat(run.code()).as(run.err()).isZero();
        return file;
    }

    @Test
    @OnLinux
    void tablesAndSheetsDoNotReplaceTheirScene() throws IOException {
        Path mesh = folder.resolve("wall.obj");
        Path link = Files.createSymbolicLink(folder.resolve("link.html"), scene);
        for (Path file : List.of(scene, link, mesh)) {
            requireKept(file, "trace", scene, "--pixel", "3,3", "-o", file);
            requireKept(file, "measure", "line", scene, "--pixel", "3,3", "--pixel", "4,3", "-o", file);
        }
        requireKept(scene, "sheet", scene, "-o", scene);
    }

    @Test
    void drawnRaysDoNotReplaceTheirScene() throws IOException {
        Path named = Files.move(scene, folder.resolve("wall.json"));
        requireKept(named, "trace", named, "--pixel", "3,3", "--draw", named);
    }

    @Test
    void filmsDoNotReplaceWhatTheyAreMadeOf() throws IOException {
        Path photograph = photograph("frame0001.png");
        Object[] film = {"animate", photograph, "--from=0", "--to=0.5", "--duration=0.2", "-o"};
        requireKept(photograph, append(film, folder, "--part=1/99"));

        Path frames = folder.resolve("frames");
        assertThat(ProgramRun.of(append(film, frames)).code()).isZero();
        Path frame = frames.resolve("frame0001.png");
        requireKept(frame, "animate", "--assemble", frames, "-o", frame);
    }

    @Test
    void photographsDoNotReplaceOtherScenes() throws IOException {
        Path photograph = photograph("wall.png");
        requireKept(photograph, "render", scene, photograph, "-o", folder);
    }

    /** Its scene stays in it. */
    @Test
    void aPhotographIsTakenAgainInItsPlace() {
        Path photograph = photograph("wall.png");
        ProgramRun run = ProgramRun.of("render", photograph, "-o", photograph, "--samples", 4, "--force");
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(ProgramRun.of("check", photograph).code()).isZero();
    }
}
