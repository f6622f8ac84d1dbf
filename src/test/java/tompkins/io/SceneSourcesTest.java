package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.OnLinux;
import tompkins.property.MistakeException;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.surface.PictureSurface;

/** Files that are no scenes, and pictures that a scene must not or cannot use, give a message. */
class SceneSourcesTest {

    @TempDir
    private Path folder;

    private String messageOf(String text) {
        return catchThrowableOfType(MistakeException.class, () -> StudioReader.read(text, "f", folder))
                .getMessage();
    }

    @Test
    @Timeout(value = 600, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void endlessNestingIsRefused() throws IOException {
        byte[] brackets = new byte[60_000_000];
        Arrays.fill(brackets, (byte) '[');
        Path file = Files.write(folder.resolve("deep.json"), brackets);
        assertThatExceptionOfType(MistakeException.class)
                .isThrownBy(() -> StudioReader.read(file))
                .withMessageStartingWith(file + ":1:201: ")
                .withMessageEndingWith("brackets and braces may be at most 200 deep");
        String objects = "{\"type\":\"Group\",\"objects\":[".repeat(300);
        assertThat(messageOf("{\"scene\": [" + objects)).endsWith("brackets and braces may be at most 200 deep");
    }

    @Test
    void largeFileIsRefused() throws IOException {
        byte[] spaces = new byte[SceneText.LARGEST + 1];
        Arrays.fill(spaces, (byte) ' ');
        Path file = Files.write(folder.resolve("large.json"), spaces);
        assertFileRefused(file, "a scene file may have at most 67108864 bytes, has 67108865");
    }

    /** Three bytes of a picture are four letters of the text. */
    @Test
    void aSceneThatWouldBeTooLargeToBeReadIsNotSaved() {
        byte[] content = new byte[3 * (SceneText.LARGEST / 4)];
        PixelPicture picture = new PixelPicture("wall.png", 1, 1, new float[4], content);
        Sphere sphere = new Sphere("", new Vector3d(), 1, new PictureSurface(picture, false, true));
        Path file = folder.resolve("large.json");

        assertThatExceptionOfType(IOException.class)
                .isThrownBy(() -> StudioWriter.save(Studio.DEFAULT.withScene(List.of(sphere)), file, true))
                .withMessageMatching(
                        Pattern.quote(file + ": not saved: a scene file may have at most 67108864 bytes, with"
                                        + " its pictures it would have ")
                                + "671\\d{5}; put them into its folder first");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void fileThatIsNoSceneIsRefused() throws IOException {
        assertFileRefused(folder, "is a folder; a scene file or a saved photograph is needed");
        assertFileRefused(folder.resolve("none.json"), "there is no such file");
        Path picture = Files.write(folder.resolve("broken.png"), new byte[] {1, 2, 3});
        assertFileRefused(
                picture, "not a picture; a photograph that holds its scene is a PNG, TIFF or Radiance HDR picture");
    }

    /** Nobody can follow a link that leads to itself, not even the administrator who may look into every folder. */
    @ParameterizedTest
    @OnLinux
    @ValueSource(strings = {"circle.json", "circle.png", "circle/scene.json", "circle/photograph.png"})
    void whatCannotBeReadIsNotSaidToBeMissing(String name) throws IOException {
        Path circle = folder.resolve(name.replaceFirst("/.*", ""));
        Files.createSymbolicLink(circle, circle);
        Path file = folder.resolve(name);
        assertThatExceptionOfType(MistakeException.class)
                .isThrownBy(() -> StudioReader.read(file))
                .withMessageStartingWith(file + ": cannot be read: ")
                .withMessageNotContainingAny("Exception", "no such file");
        assertThat(messageOf("{\"background\": {\"type\": \"PanoramaBackground\", \"picture\": \"" + name + "\"}}"))
                .startsWith("f:1:58: background.picture: cannot be read: ")
                .doesNotContain("Exception", "no such file");
    }

    private static void assertFileRefused(Path file, String message) {
        assertThatExceptionOfType(MistakeException.class)
                .isThrownBy(() -> StudioReader.read(file))
                .withMessage(file + ": " + message);
    }

    @Test
    void otherEncodingsAreRefused() throws IOException {
        Path file = folder.resolve("latin.json");
        Files.write(file, "{\n  \"title\": \"\u00fc\"}".getBytes(StandardCharsets.ISO_8859_1));
        assertThatExceptionOfType(MistakeException.class)
                .isThrownBy(() -> StudioReader.read(file))
                .withMessage(file + ":2:13: must be text in the encoding UTF-8, has here the byte 0xfc");
        Path marked = Files.writeString(folder.resolve("marked.json"), "\ufeff{\"title\": \"\u00fc\"}");
        assertThat(StudioReader.read(marked).title()).isEqualTo("\u00fc");
    }

    @Test
    void aMeshIsToldItsPlaceInAScene() throws IOException {
        assertFileRefused(
                Files.writeString(folder.resolve("knot.OBJ"), "f 1 2 3"),
                "is a mesh, not a scene; an object of a scene shows it:"
                        + " { \"type\": \"TriangleMesh\", \"mesh\": \"knot.OBJ\" }");
    }

    /** What some editors call Unicode; in a scene, in a mesh and in its materials. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "UTF-16",
                "UTF-16BE",
                "UTF-16LE",
                "UTF-32",
                "UTF-32BE",
                "UTF-32LE",
                "X-UTF-32BE-BOM",
                "X-UTF-32LE-BOM"
            })
    void textOfMoreBytesForEachLetterIsNamed(String encoding) throws IOException {
        String message = "must be text in the encoding UTF-8, is in UTF-16 or UTF-32; save it again as UTF-8";
        Charset charset = Charset.forName(encoding);
        Path scene = folder.resolve("wide.json");
        Files.write(scene, "{}".getBytes(charset));
        assertFileRefused(scene, message);
        String triangle = "mtllib wide.mtl\nv 0 0 4\nv 1 0 4\nv 0 1 4\nf 1 2 3\n";
        Path mesh = folder.resolve("wide.obj");
        Files.write(mesh, triangle.getBytes(charset));
        assertThatThrownBy(() -> MeshFile.read(mesh)).hasMessage("wide.obj:1: " + message);
        Files.writeString(mesh, triangle);
        Files.write(folder.resolve("wide.mtl"), "newmtl red\n".getBytes(charset));
        assertThat(MeshFile.read(mesh).detail().notes())
                .containsExactly("wide.mtl: its materials are not shown: " + message);
    }

    @ParameterizedTest
    @OnLinux
    @ValueSource(
            strings = {
                "../x.png",
                "a/../../x.png",
                "/etc/passwd",
                "",
                " ",
                "a\\\\b.png",
                "x\\u0000.png",
                "..",
                "link.png"
            })
    void picturesOutsideTheFolderAreRefused(String name) throws IOException {
        Path inner = Files.createDirectory(folder.resolve("inner"));
        Path outside = Files.writeString(folder.resolve("x.png"), "");
        Files.createSymbolicLink(inner.resolve("link.png"), outside);
        String text = "{\"background\": {\"type\": \"PanoramaBackground\", \"picture\": \"" + name + "\"}}";
        assertThatExceptionOfType(MistakeException.class)
                .isThrownBy(() -> StudioReader.read(text, "f", inner))
                .withMessageStartingWith("f:1:58: background.picture: ")
                .withMessageContaining(
                        "must be the name of a picture file in the folder of the scene file or below, with / between the parts");
    }

    @Test
    void filesThatAreNoPicturesAreRefused() throws IOException {
        Files.writeString(folder.resolve("x.png"), "no picture");
        String start = "{\"background\": {\"type\": \"PanoramaBackground\", \"picture\": ";
        assertThat(messageOf(start + "\"x.png\"}}"))
                .startsWith("f:1:58: background.picture: x.png: not a picture that can be read; allowed are ");
        assertThat(messageOf(start + "\"y.png\"}}"))
                .startsWith("f:1:58: background.picture: there is no such file in ");
        assertThat(messageOf(start + "{\"name\": \"z\", \"base64\": \"?\"}}}"))
                .isEqualTo("f:1:82: background.picture.base64: must be the bytes of the file in base 64, was \"?\"");
        assertThat(messageOf(start + "{\"name\": \"z\"}}}"))
                .startsWith("f:1:58: background.picture: must be the name of");
    }
}
