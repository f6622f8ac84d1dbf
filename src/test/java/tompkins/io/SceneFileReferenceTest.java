package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.GeneratedDocument;
import tompkins.camera.Camera;
import tompkins.lesson.LessonPlan;
import tompkins.lesson.Measurement;
import tompkins.lesson.MeasuringPoint;
import tompkins.light.Flash;
import tompkins.light.LightSource;
import tompkins.property.Descriptions;
import tompkins.property.MistakeException;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.Shutter;
import tompkins.studio.Studio;
import tompkins.surface.Surface;

/** The reference of scene files is up to date, complete, and its examples work. */
class SceneFileReferenceTest {

    private static final Path PROJECT = Path.of(System.getProperty("basedir", ""));

    /** One pixel. */
    private static final String PICTURE =
            "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNgAAAAAgABSK+kcQAAAABJRU5ErkJggg==";

    @TempDir
    private static Path folder;

    private static final Pattern EXAMPLE = Pattern.compile("```json\n(.*?)\n```", Pattern.DOTALL);

    @BeforeAll
    static void makeFiles() throws IOException {
        Files.createDirectory(folder.resolve("pictures"));
        Files.write(folder.resolve("pictures/clock.png"), Base64.getDecoder().decode(PICTURE));
        Files.createDirectory(folder.resolve("meshes"));
        Files.writeString(folder.resolve("meshes/trefoil.obj"), "v 0 0 9\nv 1 0 9\nv 0 1 9\nf 1 2 3\n");
    }

    @Test
    void fileIsUpToDate() throws IOException {
        GeneratedDocument.assertUpToDate("scene-files.md", SceneFileReference.markdown(), getClass());
    }

    @Test
    void everyTypeHasASectionAndEveryKeyALine() {
        String text = SceneFileReference.markdown();
        List<Class<?>> types = Families.ALL.stream()
                .flatMap(family -> Descriptions.members(family).stream())
                .toList();
        assertThat(types).hasSizeGreaterThan(30).allSatisfy(type -> {
            String section = text.split("\n### " + SceneFileReference.heading(type) + "\n", -1)[1]
                    .split("\n##", -1)[0];
            Stream.of(type.getRecordComponents())
                    .forEach(component -> assertThat(section).contains("\n| `" + component.getName() + "` |"));
        });
    }

    @Test
    void everyLinkLeadsToAHeading() {
        String text = SceneFileReference.markdown();
        List<String> anchors = text.lines()
                .filter(line -> line.startsWith("#"))
                .map(line -> ValueKind.anchor(line.replaceAll("^#+ ", "")))
                .toList();
        Matcher links = Pattern.compile("\\]\\(#([^)]*)\\)").matcher(text);
        assertThat(links.results().map(link -> link.group(1)).toList())
                .hasSizeGreaterThan(50)
                .allMatch(anchors::contains);
        assertThat(anchors).doesNotHaveDuplicates();
        assertThat(text).doesNotContain("@");
    }

    static Stream<String> examples() {
        return EXAMPLE.matcher(SceneFileReference.markdown()).results().map(example -> example.group(1));
    }

    @ParameterizedTest
    @MethodSource("examples")
    void exampleWorks(String example) {
        Matcher type = Pattern.compile("^\\{\\s*\"type\": \"(\\w+)\"").matcher(example);
        String scene = type.find() ? place(type.group(1), example) : example;
        Studio studio = StudioReader.read(scene, "example", folder);
        assertThat(StudioReader.read(StudioWriter.write(studio), "again", folder))
                .isEqualTo(studio);
    }

    /** The reference tells of comments and commas at the end; the first example is one for every reader of JSON. */
    @Test
    void theExampleOfTheReadmeWorksAndIsPlainJson() throws IOException {
        Matcher example = Pattern.compile("\n## A scene\n\n((?: {4}.*\n)+)")
                .matcher(Files.readString(PROJECT.resolve("README.md")));
        assertThat(example.find()).isTrue();
        Studio studio = StudioReader.read(example.group(1), "README.md", folder);
        assertThat(studio.velocity().speed()).isEqualTo(0.9);
        assertThat(studio.scene()).hasSize(1);
        assertThat(example.group(1)).doesNotContainPattern(",\\s*[}\\]]");
    }

    @Test
    void messagesAreThoseOfTheProgram() {
        String scene = examples().findFirst().orElseThrow();
        String wrong = scene.replace("\"radius\"", "\"raduis\"").replace("[0, 0, 0.9]", "[0, 0, 1.5]");
        assertThatExceptionOfType(MistakeException.class)
                .isThrownBy(() -> StudioReader.read(wrong, "my-scene.json", folder))
                .satisfies(mistakes -> assertThat(SceneFileReference.markdown())
                        .contains("\n    " + mistakes.getMessage().replace("\n", "\n    ") + "\n"));
    }

    /** A scene with an example at the place of its family. */
    private static String place(String type, String example) {
        boolean holdsLamps = example.contains("PointLight");
        if (!holdsLamps && DescriptionTypes.memberNames(SceneObject.class).contains(type)) {
            return "{\"scene\": [" + example + "]}";
        }
        if (DescriptionTypes.memberNames(Surface.class).contains(type)) {
            return "{\"scene\": [{\"type\": \"Sphere\", \"surface\": " + example + "}]}";
        }
        if (DescriptionTypes.memberNames(LightSource.class).contains(type)) {
            return "{\"lights\": [" + example + "]}";
        }
        if (DescriptionTypes.memberNames(Flash.class).contains(type)) {
            return "{\"lights\": [{\"type\": \"PointLight\", \"flash\": " + example + "}]}";
        }
        if (DescriptionTypes.memberNames(Shutter.class).contains(type)) {
            return "{\"camera\": {\"shutter\": " + example + "}}";
        }
        if (DescriptionTypes.memberNames(LessonPlan.class).contains(type)) {
            return "{\"lesson\": " + example + "}";
        }
        if (DescriptionTypes.memberNames(Measurement.class).contains(type)) {
            return "{\"lesson\": {\"numbers\": [{\"measurement\": " + example + "}]}}";
        }
        if (DescriptionTypes.memberNames(MeasuringPoint.class).contains(type)) {
            return place("RayReading", "{\"type\": \"RayReading\", \"point\": " + example + "}");
        }
        String key = DescriptionTypes.memberNames(Camera.class).contains(type) ? "camera" : "background";
        return "{\"" + key + "\": " + example + "}";
    }
}
