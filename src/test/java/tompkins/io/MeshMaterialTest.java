package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.MessageTable;
import tompkins.image.LinearImage;
import tompkins.ray.Colour;
import tompkins.ray.MeshDetail;
import tompkins.ray.MeshMaterial;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** What OBJ files say besides corners: it is shown, or noted. */
class MeshMaterialTest {

    @TempDir
    private Path folder;

    private static final String SQUARE = "v -1 -1 -5\nv 1 -1 -5\nv 1 1 -5\nv -1 1 -5\n";

    /** A scene with a mesh of this text, in white light from everywhere, looked at from 5 units away. */
    private Studio studio(String obj) throws IOException {
        return studio(obj, "{\"type\": \"AmbientLight\", \"colour\": 1}");
    }

    private Studio studio(String obj, String light) throws IOException {
        Files.writeString(folder.resolve("model.obj"), obj);
        String text = "{\"scene\": [{\"type\": \"TriangleMesh\", \"mesh\": \"model.obj\"}],"
                + " \"lights\": [" + light + "],"
                + " \"background\": {\"colour\": [0, 0, 1]},"
                + " \"camera\": {\"horizontalAngleDegrees\": 22, \"verticalAngleDegrees\": 22},"
                + " \"settings\": {\"width\": 8, \"height\": 8}}";
        return StudioReader.read(text, "scene.json", folder);
    }

    private static LinearImage photograph(Studio studio) throws InterruptedException {
        try (Renderer renderer = new Renderer(1)) {
            return renderer.render(RenderPlan.of(studio)).image();
        }
    }

    private static double[] pixel(LinearImage image, int x, int y) {
        return new double[] {image.value(x, y, 0), image.value(x, y, 1), image.value(x, y, 2)};
    }

    private void picture(String name, int... colours) throws IOException {
        BufferedImage image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, 2, 2, colours, 0, 2);
        Files.createDirectories(folder.resolve(name).getParent());
        ImageIO.write(image, "png", folder.resolve(name).toFile());
    }

    private void materials(String text) throws IOException {
        Files.writeString(folder.resolve("model.mtl"), text);
    }

    /** Red and green above, black and white below; the mesh turns the picture by a quarter with its coordinates. */
    @Test
    void aPictureLiesWhereTheCoordinatesSay() throws Exception {
        picture("art/wall.png", 0xffff0000, 0xff00ff00, 0xff000000, 0xffffffff);
        materials("newmtl wall\nKd 1 1 1\nmap_Kd art\\wall.png\n");
        String face = "mtllib model.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl wall\n";

        LinearImage upright = photograph(studio(SQUARE + face + "f 1/1 2/2 3/3 4/4\n"));
        assertThat(pixel(upright, 1, 1)).containsExactly(new double[] {1, 0, 0}, within(0.05));
        assertThat(pixel(upright, 6, 1)).containsExactly(new double[] {0, 1, 0}, within(0.05));
        assertThat(pixel(upright, 1, 6)).containsExactly(new double[] {0, 0, 0}, within(0.05));

        LinearImage turned = photograph(studio(SQUARE + face + "f 1/2 2/3 3/4 4/-4\n"));
        assertThat(pixel(turned, 6, 6)).containsExactly(new double[] {0, 1, 0}, within(0.05));
        assertThat(pixel(turned, 6, 1)).containsExactly(new double[] {1, 0, 0}, within(0.05));
    }

    /** The colour of a material multiplies its picture, its opacity lets the background through. */
    @Test
    void eachFaceHasItsMaterial() throws Exception {
        picture("p.png", 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff);
        // blanks of typesetters part words, as in the mesh
        materials("newmtl plain\nKd 0.5\u00a00\u20030\u00a0\nKs 0.1 0.2 0.3\n\nnewmtl dim\nKd 0 0.5 0\nmap_Kd p.png\n"
                + "newmtl thin\nKd 1 0 0\nd 0.25\n");
        String obj = "mtllib model.mtl\nvt 0 0\nv -1 -1 -5\nv 0 -1 -5\nv 0 1 -5\nv -1 1 -5\nv 1 -1 -5\nv 1 0 -5\n"
                + "v 0 0 -5\nv 1 1 -5\n";
        Studio studio =
                studio(obj + "usemtl plain\nf 1 2 3 4\nusemtl dim\nf 2/1 5/1 6/1 7/1\nusemtl thin\nf 7 6 8 3\n");

        LinearImage image = photograph(studio);

        assertThat(pixel(image, 2, 4)).containsExactly(new double[] {0.5, 0, 0}, within(1e-6));
        assertThat(pixel(image, 6, 6)).containsExactly(new double[] {0, 0.5, 0}, within(1e-6));
        assertThat(pixel(image, 6, 1)).containsExactly(new double[] {0.25, 0, 0.75}, within(1e-6));
        List<MeshMaterial> materials = detail(studio).materials();
        assertThat(materials.get(0).specular()).isEqualTo(new Colour(0.1, 0.2, 0.3));
    }

    /** The names of several files stand in one line, and the name of one file may have blanks. */
    @Test
    void aLineNamesOneFileOfMaterialsOrSeveral() throws Exception {
        Files.writeString(folder.resolve("red.mtl"), "newmtl red\nKd 1 0 0\n");
        Files.writeString(folder.resolve("green.MTL"), "newmtl green\nKd 0 1 0\n");
        Files.writeString(folder.resolve("dark red.mtl"), "newmtl dark\nKd 0.5 0 0\n");
        String obj = SQUARE + "mtllib red.mtl green.MTL\nmtllib dark red.mtl\nmtllib dark green.mtl\n";
        for (String material : List.of("red", "green", "dark")) {
            Studio studio = studio(obj + "usemtl " + material + "\nf 1 2 3 4\n");
            assertThat(detail(studio).materials().get(0).name()).isEqualTo(material);
            assertThat(detail(studio).notes())
                    .hasSize(1)
                    .first()
                    .asString()
                    .startsWith("dark green.mtl: its materials");
        }
    }

    private static MeshDetail detail(Studio studio) {
        return ((tompkins.sceneobject.TriangleMesh) studio.scene().get(0))
                .mesh()
                .detail();
    }

    /** With materials off, or without any, the mesh looks as the scene says. */
    @Test
    void materialsCanBeLeftOut() throws Exception {
        materials("newmtl red\nKd 1 0 0\n");
        String obj = SQUARE + "mtllib model.mtl\nusemtl red\nf 1 2 3 4\n";
        Studio shown = studio(obj);
        String text = StudioWriter.write(shown).replace("\"model.obj\"", "\"model.obj\", \"materials\": false");
        Studio left = StudioReader.read(text, "scene.json", folder);
        assertThat(pixel(photograph(shown), 4, 4)).containsExactly(new double[] {1, 0, 0}, within(1e-6));
        assertThat(pixel(photograph(left), 4, 4)).containsExactly(new double[] {0.8, 0.8, 0.8}, within(1e-6));
    }

    /** A flat square with the normals of a ball of radius 2: lit by a lamp it is as bright as the ball would be. */
    @Test
    void normalsBetweenTheCornersAreSmooth() throws Exception {
        StringBuilder normals = new StringBuilder();
        for (double[] corner : new double[][] {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            normals.append("vn " + corner[0] + " " + corner[1] + " " + Math.sqrt(2) + "\n");
        }
        LinearImage image = photograph(studio(
                SQUARE + normals + "f 1//1 2//2 3//3 4//4\n",
                "{\"type\": \"PointLight\", \"position\": [0, 1e6, 0], \"colour\": 1, \"highlightColour\": 0}"));
        Vector3d lamp = new Vector3d(0, 1, 0);
        double angle = Math.tan(Math.toRadians(11));
        for (int y = 0; y < 8; y++) {
            double height = 5 * angle * (1 - (y + 0.5) / 4);
            double across = 5 * angle * 0.125;
            // on each triangle of the square the normal is linear; along the diagonal both agree
            Vector3d normal = new Vector3d(across, height, -Math.sqrt(2)).normalize();
            double expected = 0.8 * Math.max(0, normal.dot(lamp));
            if (Math.abs(height) < 0.9) {
                assertThat(image.value(4, y, 1)).as("row %d", y).isCloseTo((float) expected, within(0.02f));
            }
        }
    }

    /** A ball of radius 1 about (x, 0, 8) with 10 faces from pole to pole and 20 around, and its normals. */
    private static String ball(double x, int before) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i <= 10; i++) {
            for (int j = 0; j < 20; j++) {
                double sine = Math.sin(Math.PI * i / 10);
                double[] n = {
                    sine * Math.cos(Math.PI * j / 10), Math.cos(Math.PI * i / 10), sine * Math.sin(Math.PI * j / 10)
                };
                text.append("v " + (x + n[0]) + " " + n[1] + " " + (n[2] - 8) + "\nvn " + n[0] + " " + n[1] + " " + n[2]
                        + "\n");
            }
        }
        for (int i = 0; i < 10; i++) {
            for (int j = 0; j < 20; j++) {
                int[] corner = {20 * i + j, 20 * i + (j + 1) % 20, 20 * i + 20 + (j + 1) % 20, 20 * i + 20 + j};
                text.append("f");
                for (int c : corner) {
                    text.append(" " + (before + c + 1) + "//" + (before + c + 1));
                }
                text.append("\n");
            }
        }
        return text.toString();
    }

    private LinearImage side(String obj) throws Exception {
        Studio studio = studio(obj, "{\"type\": \"PointLight\", \"position\": [-100, 40, 3], \"highlightColour\": 0}");
        return photograph(studio.withSettings(studio.settings().withSize(64, 64)));
    }

    /** What a sphere sends back by its own formula; 0 beside the middle of its picture. */
    private static double sphere(double x, int column, int row) {
        double tangent = Math.tan(Math.toRadians(11));
        Vector3d look =
                new Vector3d(tangent * ((column + 0.5) / 32 - 1), tangent * (1 - (row + 0.5) / 32), 1).normalize();
        Vector3d centre = new Vector3d(x, 0, 8);
        double along = look.dot(centre);
        double miss = centre.lengthSquared() - along * along;
        if (miss > 0.85) {
            return Double.NaN;
        }
        Vector3d point = look.mul(along - Math.sqrt(1 - miss));
        Vector3d lamp = new Vector3d(-100, 40, 3).sub(point).normalize();
        return 0.8 * Math.max(0, point.sub(centre).dot(lamp));
    }

    /** Where light ends its flat faces look away from the lamp; the light of their normals ends as on a sphere. */
    @Test
    void aSmoothBallLooksLikeASphere() throws Exception {
        LinearImage image = side(ball(0, 0));
        int inside = 0;
        for (int row = 0; row < 64; row++) {
            for (int column = 0; column < 64; column++) {
                double expected = sphere(0, column, row);
                if (!Double.isNaN(expected)) {
                    assertThat(image.value(column, row, 1))
                            .as("pixel %d, %d", column, row)
                            .isCloseTo((float) expected, within(0.03f));
                    inside++;
                }
            }
        }
        assertThat(inside).isGreaterThan(1000);
    }

    /**
     * The lamp stands at the left, and a little above: the right ball of the same mesh is in the shadow of the left.
     */
    @Test
    void aBallThrowsItsShadowOnAnotherOfItsMesh() throws Exception {
        LinearImage both = side(ball(-1.2, 0) + ball(0.4, 220));
        LinearImage one = side(ball(0.4, 0));
        // the middle of what the lamp sees of the right ball
        assertThat(one.value(26, 32, 1)).isGreaterThan(0.3f);
        assertThat(both.value(26, 32, 1)).isZero();
    }

    @Test
    void whatIsNotShownIsNotedOnce() throws IOException {
        Files.writeString(folder.resolve("bad.png"), "no picture");
        materials(
                "newmtl a\nillum 2\nNs 10\nKd 2 0 0\nmap_Kd lost.png\nnewmtl b\nKd 0x1p-1 0 0\nillum 1\nmap_Kd bad.png\n"
                        + "newmtl c\nmap_Kd -s 2 2 2 tiles.png\nd 7\n");
        MessageTable.assertTold("tompkins/io/materials.txt", this::notes, getClass());
    }

    private String notes(String lines) {
        try {
            return String.join("\n", StudioWriter.notes(studio(SQUARE + lines + "\nf 1 2 3 4\n")))
                    .replace(folder.toString(), "@");
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /** A material may be named before its library is read, and again after. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "usemtl m\nmtllib model.mtl\nusemtl m\nf 1 2 3 4\n",
                "usemtl m\nf 1 2 3 4\nmtllib model.mtl\n",
                "mtllib \"model.mtl\"\nusemtl \"m\"\nf 1 2 3 4\n",
                "usemtl lost\nusemtl m\nf 1 2 3 4\nmtllib model.mtl\n"
            })
    void aMaterialIsFoundWhereverItsLibraryStands(String lines) throws Exception {
        materials("newmtl m\nKd 0.2 0.4 0.6\n");
        Studio studio = studio(SQUARE + lines);
        assertThat(pixel(photograph(studio), 4, 4)).containsExactly(new double[] {0.2, 0.4, 0.6}, within(1e-6));
        assertThat(StudioWriter.notes(studio)).hasSize(lines.contains("lost") ? 1 : 0);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "map_Kd -clamp on -s 2 2 1 -O 0.5 wall pic.png|the option \"-clamp\" of|the option \"-s\" of|the option \"-O\" of",
                "map_KD -mm 0 1 -imfchan r \"wall pic.png\"|the option \"-mm\" of|the option \"-imfchan\" of|",
                "MAP_kd \"wall pic.png\"|||",
                "map_Kd wall pic.png|||"
            })
    void aPictureIsShownWhateverItsOptions(String line, String first, String second, String third) throws Exception {
        picture("wall pic.png", 0xffff0000, 0xffff0000, 0xffff0000, 0xffff0000);
        materials("newmtl m\nkd 1 1 1\n" + line + "\n");
        Studio studio = studio(SQUARE + "mtllib model.mtl\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1 4/1\n");

        assertThat(pixel(photograph(studio), 4, 4)).containsExactly(new double[] {1, 0, 0}, within(1e-6));
        List<String> notes = StudioWriter.notes(studio);
        List<String> told =
                Stream.of(first, second, third).filter(Objects::nonNull).toList();
        assertThat(notes).hasSameSizeAs(told);
        told.forEach(option -> assertThat(notes).anyMatch(note -> note.startsWith("model.mtl: " + option)));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Tr 0.75|0.25|",
                "tr 0|1|",
                "d 0.25|0.25|",
                "d 0.25, Tr 0.5|0.25|model.mtl: \"Tr\" is not read",
                "Tr 1.5|1|model.mtl:3: \"Tr\" must be a number from 0 to 1, was \"1.5\"",
                "Kd 0.5 0.5|1|model.mtl:3: \"Kd\" must be three numbers from 0 to 1, was \"0.5 0.5\"",
                "Kd 1 1 1 1|1|model.mtl:3: \"Kd\" must be three numbers from 0 to 1, was \"1 1 1 1\""
            })
    void opacityAndColourAreWhatTheFormatSays(String lines, double opacity, String note) throws IOException {
        materials("newmtl m\nKs 0\n" + lines.replace(", ", "\n") + "\n");
        Studio studio = studio(SQUARE + "mtllib model.mtl\nusemtl m\nf 1 2 3 4\n");
        assertThat(detail(studio).materials().get(0).opacity()).isEqualTo(opacity);
        assertThat(StudioWriter.notes(studio)).isEqualTo(note == null ? List.of() : List.of(note));
    }

    @Test
    void namesAndGroupsNeedNoNote() throws IOException {
        assertThat(StudioWriter.notes(studio("o a\ng b\ns 1\n" + SQUARE + "f 1 2 3 4\n")))
                .isEmpty();
    }

    /** Its materials would be lost inside a photograph, and so it is named there. */
    @Test
    void aMeshWithMaterialsIsOnlyNamed() throws IOException {
        materials("newmtl red\nKd 1 0 0\n");
        Studio studio = studio(SQUARE + "mtllib model.mtl\nusemtl red\nf 1 2 3 4\n");
        assertThat(StudioWriter.filesOnlyNamed(studio)).containsExactly("model.obj");
        assertThat(StudioReader.read(StudioWriter.writeSelfContained(studio), "photograph.png", folder))
                .isEqualTo(studio);
    }
}
