package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.Camera;
import tompkins.light.LightSource;
import tompkins.property.MistakeException;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.Shutter;
import tompkins.studio.Background;
import tompkins.studio.Studio;
import tompkins.surface.Surface;

/** The page about scene files names every kind of part, and its examples and messages are those of the program. */
class SceneFilesPageTest {

    private static final Path PROJECT = Path.of(System.getProperty("basedir", ""));
    private static final Path SCENES = PROJECT.resolve("scenes");
    private static final Path FILES = PROJECT.resolve("docs/scene-files");

    private static String page() {
        try {
            return Files.readString(PROJECT.resolve("docs/scene-files.md"));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    static List<String> examples() {
        return Pattern.compile("```json\n(.*?)```", Pattern.DOTALL)
                .matcher(page())
                .results()
                .map(SceneFilesPageTest::scene)
                .toList();
    }

    /** An example as a scene: a part of a scene is put where it belongs. */
    private static String scene(MatchResult example) {
        String text = example.group(1);
        String start = text.replaceAll("(?s)^\\{\\s*\"type\": \"(\\w+)\".*", "$1");
        if (DescriptionTypes.memberNames(SceneObject.class).contains(start)) {
            return "{\"scene\": [" + text + "]}";
        }
        return DescriptionTypes.memberNames(Surface.class).contains(start)
                ? "{\"scene\": [{\"type\": \"Sphere\", \"surface\": " + text + "}]}"
                : text;
    }

    @ParameterizedTest
    @MethodSource("examples")
    void exampleWorks(String scene) {
        Studio studio = StudioReader.read(scene, "example", SCENES);
        assertThat(StudioReader.read(StudioWriter.write(studio), "again", SCENES))
                .isEqualTo(studio);
        assertThat(SceneSchemaTest.check(scene)).isEmpty();
    }

    @Test
    void filesOfThePicturesAreExamples() throws IOException {
        assertThat(page())
                .contains("```json\n" + Files.readString(FILES.resolve("ball.json")) + "```\n")
                .contains("```json\n" + Files.readString(FILES.resolve("train.json")) + "```\n");
        try (Stream<Path> files = Files.list(FILES)) {
            assertThat(files).hasSize(4).allSatisfy(file -> {
                assertThat(StudioReader.read(file).scene()).isNotEmpty();
                assertThat(SceneSchemaTest.check(Files.readString(file))).isEmpty();
            });
        }
    }

    @ParameterizedTest
    @ValueSource(
            classes = {
                SceneObject.class,
                Surface.class,
                LightSource.class,
                Background.class,
                Camera.class,
                Shutter.class
            })
    void everyKindIsNamed(Class<?> family) {
        String page = page();
        assertThat(DescriptionTypes.memberNames(family)).allMatch(name -> page.contains("`" + name + "`"));
    }

    @Test
    void messagesAreThoseOfTheProgram() throws IOException {
        String wrong = Files.readString(FILES.resolve("ball.json"))
                .replace("\"centre\": [0, 0, 12]", "\"raduis\": 2")
                .replace("[0, 0, 0.9]", "[0, 0, 1.5]");
        assertThatExceptionOfType(MistakeException.class)
                .isThrownBy(() -> StudioReader.read(wrong, "my-scene.json", FILES))
                .satisfies(mistakes -> assertThat(page())
                        .contains("\n    " + mistakes.getMessage().replace("\n", "\n    ") + "\n"));
    }

    /** The first example that readers see is one for every reader of JSON. */
    @Test
    void theExampleOfTheReadmeWorksAndIsPlainJson() throws IOException {
        String example = Pattern.compile("\n## A scene\n\n((?: {4}.*\n)+)")
                .matcher(Files.readString(PROJECT.resolve("README.md")))
                .results()
                .findFirst()
                .orElseThrow()
                .group(1);
        Studio studio = StudioReader.read(example, "README.md", SCENES);
        assertThat(studio.velocity().speed()).isEqualTo(0.9);
        assertThat(studio.scene()).hasSize(1);
        assertThat(SceneSchemaTest.check(example)).isEmpty();
        assertThat(example).doesNotContainPattern(",\\s*[}\\]]");
    }
}
