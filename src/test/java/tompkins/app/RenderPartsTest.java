package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures of many scenes that several processes take together. */
class RenderPartsTest {

    @TempDir
    private Path folder;

    private List<Path> scenes;

    @BeforeEach
    void writeScenes() throws IOException {
        scenes = IntStream.range(0, 5)
                .mapToObj(i -> folder.resolve("s" + i + ".json"))
                .toList();
        for (int i = 0; i < 5; i++) {
            Files.writeString(
                    scenes.get(i),
                    "{\"velocity\": {\"beta\": 0." + i + "},"
                            + " \"settings\": {\"width\": 16, \"height\": 12, \"samples\": 1}}");
        }
    }

    private ProgramRun render(String output, Object... more) {
        Stream<Object> start = Stream.of("render", "-o", folder.resolve(output) + "/");
        return ProgramRun.of(Stream.concat(Stream.concat(start, scenes.stream()), Stream.of(more))
                .toArray());
    }

    private List<String> names(String output) throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve(output))) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void partsMakeAllPictures() throws IOException {
        assertThat(render("whole").code()).isZero();
        assertThat(render("parts", "--part=1/2").code()).isZero();
        assertThat(names("parts")).containsExactly("s1.png", "s3.png");
        assertThat(render("parts", "--part=0/2").code()).isZero();
        assertThat(names("parts")).hasSize(5);
        for (String name : names("whole")) {
            assertThat(folder.resolve("parts/" + name)).hasSameBinaryContentAs(folder.resolve("whole/" + name));
        }
        ProgramRun none = render("none", "--part=5/6");
        assertThat(none).isEqualTo(new ProgramRun(0, "", ""));
    }

    @Test
    void whatIsThereIsLeftIfItIsTheSame() throws IOException {
        assertThat(render("out", "--part=0/2").code()).isZero();
        Path picture = folder.resolve("out/s2.png");
        byte[] whole = Files.readAllBytes(picture);
        Files.write(picture, Arrays.copyOf(whole, whole.length - 40));
        ProgramRun run = render("out", "--skip-existing");
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out().lines().filter(line -> line.endsWith("(left as it is)")))
                .hasSize(2);
        assertThat(picture).hasBinaryContent(whole);
        assertThat(names("out")).hasSize(5);

        ProgramRun other = render("out", "--skip-existing", "--samples=2");
        assertThat(other.code()).isEqualTo(2);
        assertThat(other.err()).contains("s0.png: there is a file of this name already");
        assertThat(picture).hasBinaryContent(whole);
        assertThat(render("out", "--skip-existing", "--seconds=1").err())
                .contains("--skip-existing: a picture does not");
        assertThat(render("out", "--skip-existing", "--format=png16").code()).isEqualTo(2);
    }
}
