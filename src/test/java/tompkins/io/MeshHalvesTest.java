package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ray.MeshData;

/** Two threads read the halves of a large mesh, which is the same as if one had. */
class MeshHalvesTest {

    private static final int TRIANGLES = 40_000;

    private static final String RED = "mtllib red.mtl\nusemtl red\n";

    /** Triangle t has the corners (t, 0, 0), (t, 1, 0) and (t, 0, 1), in an OBJ file the last with z = -1. */
    private static String triangles() {
        return IntStream.range(0, TRIANGLES)
                .mapToObj(t -> "v " + t + " 0 0\nv " + t + " 1 0\nv " + t + " 0 -1\nf " + (3 * t + 1) + " "
                        + (3 * t + 2) + " " + (3 * t + 3) + "\n")
                .collect(Collectors.joining());
    }

    private static MeshData read(String text) throws IOException {
        assertThat(text.length()).isGreaterThan(MeshFile.LARGE_FILE);
        return MeshFile.read(
                text.getBytes(StandardCharsets.UTF_8),
                "large.obj",
                (name, noun) -> "newmtl red\nKd 1 0 0\n".getBytes(StandardCharsets.UTF_8));
    }

    private static void assertTriangles(MeshData mesh) {
        for (int t = 0; t < TRIANGLES; t++) {
            for (int corner = 0; corner < 3; corner++) {
                boolean right = mesh.coordinate(t, corner, 0) == t
                        && mesh.coordinate(t, corner, 1) == (corner == 2 ? 1 : 0)
                        && mesh.coordinate(t, corner, 2) == (corner == 1 ? 1 : 0);
                assertThat(right).as("corner %d of triangle %d", corner, t).isTrue();
            }
        }
    }

    /** Lines end in all ways, and where all are continued none may part the halves. */
    @ParameterizedTest
    @CsvSource({"'\n', '\n'", "'\n', '\r\n'", "'\n', '\r'", "' ', ' \\\\\n'", "'\nv', '\nvt 0 0\nv'"})
    void allTrianglesAreThere(String part, String becomes) throws IOException {
        MeshData mesh = read(triangles().replace(part, becomes.replace("\\\\", "\\")));

        assertThat(mesh.triangles()).isEqualTo(TRIANGLES);
        assertTriangles(mesh);
    }

    /** The second half alone does not say which vertices these are, nor of what material. */
    @ParameterizedTest
    @ValueSource(strings = {"f -3 -2 -1\n", "usemtl red\nf -3 -2 -1\n", "f 119998 119999 120000\n"})
    void aSecondHalfMayNeedTheFirst(String last) throws IOException {
        MeshData mesh = read(RED + triangles() + last);

        assertThat(mesh.triangles()).isEqualTo(TRIANGLES + 1);
        assertTriangles(mesh);
        assertThat(mesh.coordinate(TRIANGLES, 1, 0)).isEqualTo(TRIANGLES - 1);
        assertThat(mesh.detail().material(0)).isZero();
        assertThat(mesh.detail().material(TRIANGLES)).isZero();
        assertThat(mesh.detail().notes()).isEmpty();
    }

    @Test
    void whatIsNotReadInTheSecondHalfIsNoted() throws IOException {
        MeshData mesh = read(RED + triangles() + "usemtl blue\nf 1 2 3\n");

        assertThat(mesh.detail().material(TRIANGLES - 1)).isZero();
        assertThat(mesh.detail().material(TRIANGLES)).isEqualTo(-1);
        assertThat(mesh.detail().notes()).hasSize(1);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            f 1 2         | a face must have three or more corners, has 2
            f 1 2 120001  | a face names vertex 120001, but there are only 120000
            f 1 2 -120001 | a face names vertex -120001, but there are only 120000 above it
            """)
    void aMistakeIsReportedWithItsLine(String line, String message) {
        assertThatThrownBy(() -> read(triangles() + line + "\n"))
                .hasMessage("large.obj:" + (4 * TRIANGLES + 1) + ": " + message);
    }

    /** Normals are counted through both halves; one that is missing is noted. */
    @Test
    void normalsAreThoseOfTheWholeFile() throws IOException {
        String normals = "vn 0 0 -1\n".repeat(TRIANGLES);

        MeshData mesh = read(normals + triangles() + "vn 0 -3 0\nf 1//40001 2//40001 3//40000\nf 1//1 2//40002 3//1\n");

        assertTriangles(mesh);
        assertThat(mesh.detail().hasNormals(TRIANGLES - 1)).isFalse();
        assertThat(mesh.detail().normal(TRIANGLES, 0, 1)).isEqualTo(-1);
        // z is turned over, and so are the second and third corner
        assertThat(mesh.detail().normal(TRIANGLES, 1, 2)).isEqualTo(1);
        assertThat(mesh.detail().hasNormals(TRIANGLES + 1)).isFalse();
        assertThat(mesh.detail().notes()).hasSize(1);
    }
}
