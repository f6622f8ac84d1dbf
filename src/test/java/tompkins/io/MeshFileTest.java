package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.OnLinux;
import tompkins.file.FileException;
import tompkins.image.PictureFile;
import tompkins.property.MistakeException;
import tompkins.ray.MeshData;
import tompkins.sceneobject.TriangleMesh;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;

class MeshFileTest {

    private static final String SQUARE = "# square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.1 1e0 -0.30000000000000004\n";

    @Test
    void convexFacesAreFansTurnedOver() throws IOException {
        MeshData mesh = read(SQUARE + "f 1 2 3 4\n");

        assertThat(mesh.triangles()).isEqualTo(2);
        assertThat(corners(mesh, 0)).isEqualTo(List.of(0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0));
        assertThat(corners(mesh, 1)).isEqualTo(List.of(0.0, 0.0, 0.0, 0.1, 1.0, 0.30000000000000004, 1.0, 1.0, 0.0));
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

        assertThat(corners(mesh, 0)).isEqualTo(List.of(0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0));
    }

    /** Blanks of all kinds part words; a backslash does so too, whatever it touches. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "v\t0\t0\t0\nv\t1\t0\t0\nv\t1\t1\t0\nf\t1\t2\t3\n",
                "\tv 0 0 0\t\n \t v 1  0 \t0\nv 1 1 0 \nf 1\t 2 3\t\t\n",
                "v\u000b0 0\f0\nv\u00a01 0 0\nv 1\u20031\u30000\nf 1\u00852\u202f3\n",
                "v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3\r",
                "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 2 3\r\n",
                "v 0 0\\\n0\nv 1\\\r\n0\\\r\n0\nv \\\n1 1 0\nf 1\\\n2\\\n3",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nf\\\n1\t\\ \t\n\\\n\t2 3\\",
                "# a path C:\\meshes\\\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 \\ # on\n",
                "v 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nf -3/\t-2/1/ +3//7",
                "v 0. .0 -0\nv 1e0 0E-5 0\nV +1.0e+0 1 0\nf 00001 2 3",
            })
    void allKindsOfBlanksPartWords(String text) throws IOException {
        MeshData mesh = read(text);

        assertThat(mesh.triangles()).isEqualTo(1);
        assertThat(corners(mesh, 0)).isEqualTo(List.of(0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "0.1",
                "-0.30000000000000004",
                "+.5",
                "7.",
                "1e3",
                "2.5E-7",
                "-1.2246467991473532E-16",
                "4.9e-324",
                "9007199254740993",
                "0.1000000000000000055511151231257827021181583404541015625",
                "1e-400",
                "6.02e+23",
                "123456789012345678901234567890",
                "0.00000000000000000000000000000012",
                "1.7976931348623157e308",
            })
    void numbersAreRoundedAsJavaDoes(String number) throws IOException {
        MeshData mesh = read("v " + number + " 0 0\nv 1 2 0\nv 1 1 0\nf 1 2 3\n");

        assertThat(mesh.coordinate(0, 0, 0)).isEqualTo(Double.parseDouble(number));
    }

    @ParameterizedTest
    @ValueSource(strings = {"e5", ".", ".e5", "5e", "5e+", "+", "5+5", "--5", "1.2.3", "1e2.5", "1e2e3", "0x1p3", "1d"})
    void whatOnlyLooksLikeANumberIsRefused(String word) {
        assertThatThrownBy(() -> read(SQUARE + "v 0 " + word + " 0\n"))
                .hasMessageContaining("coordinates must be finite numbers, one was ");
    }

    @Test
    @Timeout(600)
    void manyDigitsThatAreNoNumberAreRefusedSoon() {
        String word = "1".repeat(10_000_000) + "x";
        assertThatThrownBy(() -> read(SQUARE + "v 0 " + word + " 0\n"))
                .hasMessageContaining("coordinates must be finite numbers, one was ");
    }

    @Test
    void numbersBelowZeroCountBackFromTheirFace() throws IOException {
        String text = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 2 1 0\nf -4 -3 -1\n";

        MeshData mesh = read(text);

        assertThat(mesh).isEqualTo(read(text.replace("-3 -2 -1", "2 3 4").replace("-4 -3 -1", "2 3 5")));
    }

    /** The letter is in front of its plate, for one who looks along +z, and its long bar is on the left. */
    @Test
    void lettersReadAsTheyWereModelled() throws IOException {
        MeshData letter;
        try (InputStream in = MeshFileTest.class.getResourceAsStream("meshes/letter-f.obj")) {
            letter = read(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }

        assertThat(letter.triangles()).isEqualTo(8);
        List<Double> plate = corners(letter, 6);
        assertThat(List.of(plate.get(2), plate.get(5), plate.get(8))).containsOnly(0.0);
        for (int triangle = 0; triangle < 6; triangle++) {
            List<Double> at = corners(letter, triangle);
            assertThat(List.of(at.get(2), at.get(5), at.get(8))).containsOnly(-0.1);
        }
        assertThat(corners(letter, 0).get(0)).isEqualTo(-0.5);
        for (int triangle = 0; triangle < 8; triangle++) {
            List<Double> at = corners(letter, triangle);
            double normal = (at.get(3) - at.get(0)) * (at.get(7) - at.get(1))
                    - (at.get(4) - at.get(1)) * (at.get(6) - at.get(0));
            assertThat(normal).as("towards the reader, who is at smaller z").isNegative();
        }
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
                "f 1 2 -7            | 6: a face names vertex -7, but there are only 4 above it",
                "f 1 2 2147483648    | 6: a face names vertex 2147483648, but there are only 4 above it",
                "f 4294967297 2 3    | 6: a face names vertex 4294967297, but there are only 4 above it",
                "f 1 18446744073709551617 3 | 6: a face names vertex 18446744073709551617, but there are only 4",
                "f 1 2 -4294967297   | 6: a face names vertex -4294967297, but there are only 4 above it",
                "f 1 -18446744073709551617 3 | 6: a face names vertex -18446744073709551617, but there are only 4",
                "f 1 2 2147483647    | 6: a face names vertex 2147483647, but there are only 4",
                "f                   | 6: a face must have three or more corners, has 0",
                "v                   | 6: a vertex must have three coordinates, has 0",
                "v 0x1 2 3           | 6: coordinates must be finite numbers, one was 0x1",
                "v 0,5 2 3           | 6: coordinates must be finite numbers, one was 0,5",
                "v inf 2 3           | 6: coordinates must be finite numbers, one was inf",
                "v 1 nan(ind) 3      | 6: coordinates must be finite numbers, one was nan(ind)",
                "f 1 2/x 3           | 6: \"f 1 2/x 3\" cannot be understood; a vertex is written like",
                "f 1.0 2 3           | 6: \"f 1.0 2 3\" cannot be understood; a vertex is written like",
                "f 1 2 -0            | 6: \"f 1 2 -0\" cannot be understood; a vertex is written like",
                "f 1 2               | 6: a face must have three or more corners, has 2",
                "v 1 2               | 6: a vertex must have three coordinates, has 2",
                "v 1 nought 3        | 6: coordinates must be finite numbers, one was nought",
                "v 1 NaN 3           | 6: coordinates must be finite numbers, one was NaN",
                "v 1 1e999 3         | 6: coordinates must be finite numbers, one was 1e999",
                "v 1 1e19999999999999999999 3 | 6: coordinates must be finite numbers, one was 1e19999999999999999999",
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

    /** A control character is no blank, also at the end of a line. */
    @ParameterizedTest
    @ValueSource(strings = {"f 1 2 -3\0", "v -5\0 2 3", "\0v 1 2 3\0", "f 1 2 3\u001b"})
    void controlCharactersAreNotPassedOver(String line) throws IOException {
        if (line.startsWith("\0")) {
            assertThat(read(SQUARE + line + "\nf 1 2 3\n").detail().notes()).hasSize(1);
        } else {
            assertThatThrownBy(() -> read(SQUARE + line + "\n"))
                    .hasMessageMatching(".*(cannot be understood|coordinates must be finite numbers).*");
        }
    }

    @Test
    void aMeshIsFoundBesideTheSceneFileAndSmallOnesAreKept(@TempDir Path folder) throws IOException {
        Files.createDirectory(folder.resolve("meshes"));
        Files.writeString(folder.resolve("meshes/square.obj"), SQUARE + "f 1 2 3 4\n");
        String text = "{\"scene\": [{\"type\": \"TriangleMesh\", \"mesh\": \"meshes/square.obj\"}]}";

        Studio studio = StudioReader.read(text, "scene.json", folder);

        assertThat(studio.scene())
                .containsExactly(new TriangleMesh(
                        "mesh", read(SQUARE + "f 1 2 3 4", "meshes/square.obj"), ColouredSurface.DEFAULT, true));
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
                .isInstanceOf(MistakeException.class)
                .hasMessageContaining("photograph.png:")
                .hasMessageContaining("scene[0].mesh")
                .hasMessageContaining("there is no such file")
                .hasMessageContaining("large.obj");
    }

    @Test
    void aSceneIsSavedOnlyWhereItsLargeMeshIsFound(@TempDir Path folder) throws IOException {
        Studio studio = withLargeMesh(folder);

        Path beside = folder.resolve("beside.json");
        StudioWriter.save(studio, beside, true);
        assertThat(StudioReader.read(beside)).isEqualTo(studio);

        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere")).resolve("scene.json");
        assertThatThrownBy(() -> StudioWriter.save(studio, elsewhere, true))
                .isInstanceOf(IOException.class)
                .hasMessage(elsewhere
                        + ": not saved: large.obj cannot be held by a scene file, since it is large or has materials, and does not"
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

        assertThatThrownBy(() -> StudioWriter.save(studio, scene, true))
                .isInstanceOf(IOException.class)
                .hasMessage(scene
                        + ": not saved: large.obj cannot be held by a scene file, since it is large or has materials, and another file"
                        + " of this name lies in " + elsewhere
                        + "; save the scene in the folder of the right one");
        assertThat(scene).doesNotExist();

        Files.copy(folder.resolve("large.obj"), mesh, StandardCopyOption.REPLACE_EXISTING);
        StudioWriter.save(studio, scene, true);
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
    @OnLinux
    void aDeviceIsNoMesh() {
        assertThatThrownBy(() -> MeshFile.read(Path.of("/dev/zero"))).hasMessage("/dev/zero: not a file");
    }

    @Test
    void meshMistakesNameSceneMeshAndBothLines(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("bad.obj"), SQUARE + "f 1 2 9\n");

        assertThatThrownBy(() -> StudioReader.read(
                        "{\"scene\": [\n{\"type\": \"TriangleMesh\", \"mesh\": \"bad.obj\"}]}", "scene.json", folder))
                .isInstanceOf(MistakeException.class)
                .hasMessageContaining("scene.json:2:")
                .hasMessageContaining("bad.obj:6: a face names vertex 9, but there are only 4");
    }

    private static MeshData read(String text) throws IOException {
        return read(text, "knot.obj");
    }

    private static MeshData read(String text, String name) throws IOException {
        return MeshFile.read(text.getBytes(StandardCharsets.UTF_8), name, FileKind.Files.NONE);
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
