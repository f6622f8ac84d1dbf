package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.image.FileException;
import tompkins.image.PictureFile;
import tompkins.ray.MeshData;
import tompkins.sceneobject.TriangleMesh;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;

class MeshFileTest {

    private static final String SQUARE = "# square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.1 1e0 -0.30000000000000004\n";

    @Test
    void facesOfManyCornersAreCutIntoFans() throws IOException {
        MeshData mesh = read(SQUARE + "f 1 2 3 4\n");

        assertThat(mesh.triangles()).isEqualTo(2);
        assertThat(corners(mesh, 0)).isEqualTo(List.of(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0));
        assertThat(corners(mesh, 1)).isEqualTo(List.of(0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.1, 1.0, -0.30000000000000004));
    }

    @ParameterizedTest
    @CsvSource({"f -4 -3 -2", "f 1/1 2/2 3/3", "f 1/1/1 2/1/1 3/1/1", "f 1//1 2//1 3//1", "F 1 2 3", "'f 1 \\\n 2 3'"})
    void allWaysToWriteAFaceMeanTheSame(String face) throws IOException {
        String text = SQUARE + "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nusemtl brass\ng knot\ns off\n" + face + "\n";

        assertThat(corners(read(text), 0)).isEqualTo(corners(read(SQUARE + "f 1 2 3"), 0));
    }

    /** What some programs write, and what would cost the first vertex or the whole mesh. */
    @ParameterizedTest
    @ValueSource(strings = {"vn nan nan nan", " vn -nan(ind) 0 0", "vt 0,5 0,5", "vn 0 0 \\\n 1", "# v 1 2", "  "})
    void whatAMeshDoesWithoutIsPassedOver(String line) throws IOException {
        String vertices = "\uFEFFv 0 0 0 # first\nv 1 0 0\nv 1 1 0\n";

        MeshData mesh = read(vertices + line + "\nf 1//1 2//1 3//1 # face\n");

        assertThat(corners(mesh, 0)).isEqualTo(List.of(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", SQUARE, "\u0089PNG\r\n\u001a\n\u0000\u0000"})
    void aFileWithoutFacesHasNoLineToName(String text) {
        assertThatThrownBy(() -> read(text))
                .hasMessage("knot.obj: not an OBJ file with triangles: it has no lines such as \"f 1 2 3\"");
    }

    @Test
    void aMeshOfWhichNothingIsToBeSeenIsRefused(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("flat.obj"), SQUARE + "f 1 1 1\nf 1 2 2\n");
        String text = "{\"scene\": [{\"type\": \"TriangleMesh\", \"mesh\": \"flat.obj\"}]}";

        assertThatThrownBy(() -> StudioReader.read(text, "scene.json", folder))
                .hasMessage("scene.json:1:45: scene[0].mesh: must be triangles, at least one of them with an area,"
                        + " was \"flat.obj\"");
    }

    @Test
    void facesMayComeBeforeTheirVertices() throws IOException {
        assertThat(read("f 1 2 3\n" + SQUARE)).isEqualTo(read(SQUARE + "f 1 2 3\n"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "f 1 2 5             | 6: a face names vertex 5, but there are only 4",
                "f 1 2 -7            | 6: a face counts 3 vertices back beyond the first",
                "f 1 2 2147483648    | 6: a face names a vertex beyond number 2147483647",
                "f 1 2               | 6: a face must have three or more corners, has 2",
                "v 1 2               | 6: a vertex must have three coordinates, has 2",
                "v 1 nought 3        | 6: \"v 1 nought 3\" cannot be understood; a vertex is written like",
                "v 1 NaN 3           | 6: coordinates must be finite, one was NaN",
                "v 1 1e999 3         | 6: coordinates must be finite, one was Infinity",
                "f one two three     | 6: \"f one two three\" cannot be understood; a vertex is written like",
                "f 0 1 2             | 6: \"f 0 1 2\" cannot be understood; a vertex is written like \"v 0 1.5 -2\", a face"
                        + " like \"f 1 2 3\" with vertices counted from 1",
            })
    void aMistakeIsReportedWithItsLine(String line, String message) {
        assertThatThrownBy(() -> read(SQUARE + line + "\n"))
                .isInstanceOf(FileException.class)
                .hasMessageStartingWith("knot.obj:" + message)
                .hasMessageMatching("knot.obj:6: [\"a-zA-Z].+");
    }

    @Test
    void aMeshIsFoundBesideTheSceneFileAndSmallOnesAreKept(@TempDir Path folder) throws IOException {
        Files.createDirectory(folder.resolve("meshes"));
        Files.writeString(folder.resolve("meshes/square.obj"), SQUARE + "f 1 2 3 4\n");
        String text = "{\"scene\": [{\"type\": \"TriangleMesh\", \"mesh\": \"meshes/square.obj\"}]}";

        Studio studio = StudioReader.read(text, "scene.json", folder);

        assertThat(studio.scene())
                .containsExactly(new TriangleMesh(
                        "mesh", read(SQUARE + "f 1 2 3 4", "meshes/square.obj"), ColouredSurface.DEFAULT));
        assertThat(StudioWriter.write(studio)).contains("\"meshes/square.obj\"").doesNotContain("base64");
        String whole = StudioWriter.writeSelfContained(studio);
        assertThat(StudioReader.read(whole, "photograph.png", folder.resolve("elsewhere")))
                .isEqualTo(studio);
    }

    /** A scene in a folder with a mesh, large.obj, that is too large to be kept. */
    private static Studio withLargeMesh(Path folder) throws IOException {
        String comments = "# nothing to see here\n".repeat(60_000);
        Files.writeString(folder.resolve("large.obj"), comments + SQUARE + "f 1 2 3 4\n");
        String text = "{\"scene\": [{\"type\": \"TriangleMesh\", \"mesh\": \"large.obj\"}]}";
        return StudioReader.read(text, "scene.json", folder);
    }

    @Test
    void aLargeMeshIsOnlyNamed(@TempDir Path folder) throws IOException {
        Studio studio = withLargeMesh(folder);
        String whole = StudioWriter.writeSelfContained(studio);

        assertThat(whole).hasSizeLessThan(1000).contains("large.obj");
        assertThat(StudioReader.read(whole, "photograph.png", folder)).isEqualTo(studio);
        assertThatThrownBy(() -> StudioReader.read(whole, "photograph.png", folder.resolve("elsewhere")))
                .isInstanceOf(SceneFileException.class)
                .hasMessageContaining("photograph.png:")
                .hasMessageContaining("scene[0].mesh")
                .hasMessageContaining("there is no such file")
                .hasMessageContaining("large.obj");
    }

    @Test
    void aSceneIsSavedOnlyWhereItsLargeMeshIsFound(@TempDir Path folder) throws IOException {
        Studio studio = withLargeMesh(folder);

        Path beside = folder.resolve("beside.json");
        StudioWriter.save(studio, beside);
        assertThat(StudioReader.read(beside)).isEqualTo(studio);

        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere")).resolve("scene.json");
        assertThatThrownBy(() -> StudioWriter.save(studio, elsewhere))
                .isInstanceOf(IOException.class)
                .hasMessage(elsewhere + ": not saved: large.obj is too large to be held by a scene file, and does not"
                        + " lie in " + elsewhere.getParent() + "; copy it there first");
        assertThat(elsewhere.getParent()).isEmptyDirectory();
    }

    @ParameterizedTest
    @ValueSource(strings = {SQUARE + "f 1 2 3\n", "no mesh at all"})
    void aSceneIsNotSavedBesideAnotherMeshOfTheName(String other, @TempDir Path folder) throws IOException {
        Studio studio = withLargeMesh(folder);
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
        Path mesh = Files.writeString(elsewhere.resolve("large.obj"), other);
        Path scene = elsewhere.resolve("scene.json");

        assertThatThrownBy(() -> StudioWriter.save(studio, scene))
                .isInstanceOf(IOException.class)
                .hasMessage(scene + ": not saved: large.obj is too large to be held by a scene file, and another file"
                        + " of this name lies in " + elsewhere
                        + "; save the scene in the folder of the right one");
        assertThat(scene).doesNotExist();

        Files.copy(folder.resolve("large.obj"), mesh, StandardCopyOption.REPLACE_EXISTING);
        StudioWriter.save(studio, scene);
        assertThat(StudioReader.read(scene)).isEqualTo(studio);
    }

    /** One limit for pictures and meshes, however they are read. */
    @Test
    void filesTooLargeToBeReadAreRefusedWithOneMessage(@TempDir Path folder) throws IOException {
        Path large = folder.resolve("large.bin");
        try (RandomAccessFile file = new RandomAccessFile(large.toFile(), "rw")) {
            file.setLength((256 << 20) + 1);
        }
        String message = "cannot be read: it has 268435457 bytes, and may have at most 268435456";

        assertThatThrownBy(() -> MeshFile.read(large)).hasMessage(large + ": " + message);
        assertThatThrownBy(() -> PictureFile.read(large)).hasMessage(large + ": " + message);
        String text = "{\"scene\": [{\"type\": \"TriangleMesh\", \"mesh\": \"large.bin\"}]}";
        assertThatThrownBy(() -> StudioReader.read(text, "scene.json", folder))
                .hasMessage("scene.json:1:45: scene[0].mesh: " + message + ", was \"large.bin\"");
    }

    /** It would never end. */
    @Test
    void aDeviceIsNoMesh() {
        assertThatThrownBy(() -> MeshFile.read(Path.of("/dev/zero"))).hasMessage("/dev/zero: not a file");
    }

    @Test
    void aMistakeInAMeshNamesTheSceneFileTheMeshAndBothLines(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("bad.obj"), SQUARE + "f 1 2 9\n");

        assertThatThrownBy(() -> StudioReader.read(
                        "{\"scene\": [\n{\"type\": \"TriangleMesh\", \"mesh\": \"bad.obj\"}]}", "scene.json", folder))
                .isInstanceOf(SceneFileException.class)
                .hasMessageContaining("scene.json:2:")
                .hasMessageContaining("bad.obj:6: a face names vertex 9, but there are only 4");
    }

    private static MeshData read(String text) throws IOException {
        return read(text, "knot.obj");
    }

    private static MeshData read(String text, String name) throws IOException {
        return MeshFile.read(text.getBytes(StandardCharsets.UTF_8), name);
    }

    private static List<Double> corners(MeshData mesh, int triangle) {
        return IntStream.range(0, 9)
                .mapToObj(i -> mesh.coordinate(triangle, i / 3, i % 3))
                .toList();
    }

    /**
     * The signed volume of what is closed is positive if its corners run counter-clockwise seen from outside: glass
     * asks for that.
     */
    @Test
    void theTrefoilHasItsOutsideOutside() throws IOException {
        MeshData trefoil =
                read(Files.readString(Path.of(System.getProperty("basedir", "")).resolve("scenes/meshes/trefoil.obj")));
        double volume = 0;
        for (int triangle = 0; triangle < trefoil.triangles(); triangle++) {
            List<Double> at = corners(trefoil, triangle);
            Vector3d first = new Vector3d(at.get(0), at.get(1), at.get(2));
            Vector3d second = new Vector3d(at.get(3), at.get(4), at.get(5));
            Vector3d third = new Vector3d(at.get(6), at.get(7), at.get(8));
            volume += first.dot(second.cross(third)) / 6;
        }
        // corners of a polyhedron: a little less than a tube around a knot
        assertThat(volume).isBetween(0.8, 0.9);
    }
}
