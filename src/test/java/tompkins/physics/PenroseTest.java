package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Matrix3d;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.Cameras;
import tompkins.camera.ThinLensCamera;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;

/** The outline of a moving sphere is a circle: fitted in rendered pictures. */
class PenroseTest {

    /** A circle of directions n . d = cos(radius). */
    private record Circle(Vector3d centre, double radius) {

        /** Least squares: directions on a circle lie in the plane p . d = 1 with p along the centre. */
        static Circle through(List<Vector3d> directions) {
            Matrix3d squares = new Matrix3d().zero();
            Vector3d sums = new Vector3d();
            for (Vector3d d : directions) {
                squares.add(new Matrix3d(
                        d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.x, d.y * d.y, d.y * d.z, d.z * d.x, d.z * d.y,
                        d.z * d.z));
                sums.add(d);
            }
            Vector3d p = squares.invert().transform(sums);
            double cosine = 1 / p.length();
            return new Circle(p.normalize(), Math.acos(Math.min(1, cosine)));
        }

        double distance(Vector3d direction) {
            return Math.abs(
                    Math.atan2(centre.cross(direction, new Vector3d()).length(), centre.dot(direction)) - radius);
        }
    }

    static Stream<GoldenRow> outlinesInView() {
        return GoldenTable.rows("d_sphere_outlines").stream()
                .filter(row -> row.number("rho") > 0.005 && row.number("rho") < 0.6)
                .filter(row -> !row.has("class", "rest"))
                .limit(6);
    }

    @ParameterizedTest
    @MethodSource("outlinesInView")
    void renderedOutlineIsTheReferenceCircle(GoldenRow row) {
        double radius = row.number("rho");
        Vector3d centre = row.vector("ctr_");
        double degrees = 2 * Math.toDegrees(Math.atan(Math.tan(radius) * 1.6));
        ThinLensCamera camera = Cameras.lens(
                row.vector("o"),
                centre,
                Math.abs(centre.y) < 0.9 ? new Vector3d(0, 1, 0) : new Vector3d(0, 0, 1),
                degrees,
                0,
                0,
                ThinLensCamera.DEFAULT.focus(),
                0,
                new AperturePlaneShutter(row.number("t0")));
        SceneObject sphere = new Sphere("sphere", row.vector("C"), row.number("R"), Photograph.WHITE);
        Photograph photograph =
                Photograph.of(List.of(sphere), camera, Velocity.of(row.vector("beta_", "_hex")), 640, 480);
        List<Vector3d> outline =
                photograph.outline().stream().map(photograph::cameraDirection).toList();
        assertThat(outline).hasSizeGreaterThan(500);
        double pixel = photograph
                .cameraDirection(new Vector2d(320, 240))
                .distance(photograph.cameraDirection(new Vector2d(321, 240)));
        Circle fitted = Circle.through(outline);
        double meanSquare = outline.stream()
                .mapToDouble(fitted::distance)
                .map(distance -> distance * distance)
                .average()
                .orElseThrow();
        assertThat(Math.sqrt(meanSquare) / pixel).as("residual in pixels").isLessThan(0.5);
        assertThat(fitted.radius() / pixel).isCloseTo(radius / pixel, within(0.2));
        assertThat(fitted.centre().distance(centre) / pixel).isLessThan(0.2);
        // the circle of the reference itself, not only the fitted one
        Circle reference = new Circle(centre, radius);
        assertThat(outline.stream().mapToDouble(reference::distance).max().orElseThrow() / pixel)
                .as("farthest in pixels")
                .isLessThan(1);
    }

    /**
     * Speed, angle of the sphere from the velocity and its angular radius in the scene, angular radius for the camera.
     */
    @ParameterizedTest
    @CsvSource({
        "0.9, 90, 10, 4.39506",
        "0.99, 90, 20, 2.93923",
        "0.8, 0, 20, 6.72745",
        "0.8, 180, 20, 55.75597",
        "0.9, 135, 15, 18.89897"
    })
    void spheresSwellAndShrink(double speed, double sceneAngle, double sceneRadius, double cameraRadius) {
        SceneObject sphere = new Sphere(
                "sphere",
                Photograph.level(sceneAngle).mul(10),
                10 * Math.sin(Math.toRadians(sceneRadius)),
                Photograph.WHITE);
        Photograph photograph =
                Photograph.of(List.of(sphere), Photograph.wholeSky(), Velocity.of(0, 0, speed), 1440, 720);
        List<Vector3d> outline =
                photograph.outline().stream().map(photograph::cameraDirection).toList();
        Circle fitted = Circle.through(outline);
        assertThat(Math.toDegrees(fitted.radius())).isCloseTo(cameraRadius, within(0.05));
    }
}
