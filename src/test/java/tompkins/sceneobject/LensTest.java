package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.ThinLensCamera;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Refractive;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

class LensTest {

    private static final double INDEX = 1.5;
    private static final Vector3dc MIDDLE = new Vector3d(0, 0, 10);
    private static final Vector3dc TO_CAMERA = new Vector3d(0, 0, -1);
    private static final double WALL = 11;

    private static Lens lens(double edge, double front, double back) {
        return new Lens("lens", MIDDLE, TO_CAMERA, 1, edge, front, back, new Refractive(INDEX));
    }

    /** The main branch of a ray from a point into a lens and on to a wall. */
    private static List<SampleHistory.Encounter> ray(Lens lens, double x, double pixelX, double pixelY) {
        Plane wall = new Plane("wall", new Vector3d(0, 0, WALL), TO_CAMERA, ColouredSurface.DEFAULT);
        Studio studio = Studio.DEFAULT
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d(x, 0, 0)))
                .withSettings(Studio.DEFAULT.settings().withSize(400, 300))
                .withScene(List.of(lens, wall));
        return SampleHistory.of(RenderPlan.of(studio), pixelX, pixelY, 0, 0).mainHits();
    }

    /**
     * The lensmaker's equation: a ray at the height h, parallel to the axis, leaves at an angle with the tangent h/f,
     * but for a part h^2 of it.
     */
    @ParameterizedTest
    @CsvSource({"0, 0.5, 0.5", "0, 0.3, 0", "0.1, 0, 0.7", "0.1, -0.8, 0.9", "0.4, -0.3, -0.2", "0, 1, 1"})
    void bringsParallelRaysToItsFocus(double edge, double front, double back) {
        double height = 1e-4;
        List<SampleHistory.Encounter> hits = ray(lens(edge, front, back), height, 200, 150);
        assertThat(hits).hasSize(3);
        Vector3d out = hits.get(1).event().position();
        Vector3d wall = hits.get(2).event().position();
        double power = (out.x - wall.x) / (wall.z - out.z) / height;

        double thickness = edge + sagitta(front) + sagitta(back);
        double expected = (INDEX - 1) * (front + back - (INDEX - 1) * thickness * front * back / INDEX);
        assertThat(power).isCloseTo(expected, within(1e-7));
    }

    /** Of a circle that goes through the rim. */
    private static double sagitta(double curvature) {
        return curvature == 0 ? 0 : 1 / curvature - Math.signum(curvature) * Math.sqrt(1 / (curvature * curvature) - 1);
    }

    /**
     * Faces are parts of spheres, and both obey Snell's law as vectors: the cross product of direction and normal is
     * divided by the ratio of the indices.
     */
    @ParameterizedTest
    @CsvSource({"0, 0.5, 0.4", "0.4, -0.3, -0.2", "0.1, -0.8, 0.9"})
    void bothFacesFollowSnell(double edge, double front, double back) {
        Lens lens = lens(edge, front, back);
        SplittableRandom random = new SplittableRandom(1621);
        int through = 0;
        for (int i = 0; i < 100; i++) {
            List<SampleHistory.Encounter> hits =
                    ray(lens, 0, 200 + random.nextDouble(-35, 35), 150 + random.nextDouble(-35, 35));
            if (hits.size() != 3
                    || Math.abs(hits.get(1).event().z() - MIDDLE.z()) <= edge / 2 + 1e-9
                            && edge > 0
                            && Math.hypot(
                                            hits.get(1).event().x(),
                                            hits.get(1).event().y())
                                    > 1 - 1e-9) {
                continue;
            }
            through++;
            Vector3d in = hits.get(0).event().position();
            Vector3d out = hits.get(1).event().position();
            Vector3d inside = new Vector3d(out).sub(in).normalize();
            Vector3d onwards = hits.get(2).event().position().sub(out).normalize();
            // centres lie behind bulging faces
            Vector3d normalIn = fromCentre(in, MIDDLE.z() - edge / 2 - sagitta(front) + 1 / front, front);
            Vector3d normalOut = fromCentre(out, MIDDLE.z() + edge / 2 + sagitta(back) - 1 / back, back);
            Vector3d before = new Vector3d(in).normalize().cross(normalIn);
            assertThat(before.distance(inside.cross(normalIn, new Vector3d()).mul(INDEX)))
                    .isLessThan(1e-13);
            assertThat(inside.cross(normalOut, new Vector3d()).mul(INDEX).distance(onwards.cross(normalOut)))
                    .isLessThan(2e-13);
        }
        assertThat(through).isGreaterThan(50);
    }

    /** The unit vector from the centre of a sphere on the axis, whose radius is checked. */
    private static Vector3d fromCentre(Vector3d place, double centre, double curvature) {
        Vector3d from = new Vector3d(place).sub(0, 0, centre);
        assertThat(from.length()).isCloseTo(1 / Math.abs(curvature), within(1e-13));
        return from.normalize();
    }

    /** Two half balls are a ball, near and far. */
    @ParameterizedTest
    @CsvSource({"3, 1e-14", "1e6, 5e-9"})
    void halfBallsAreABall(double away, double error) {
        Lens lens = new Lens("", MIDDLE, new Vector3d(1, 2, -2), 0.7, 0, 1 / 0.7, 1 / 0.7, ColouredSurface.DEFAULT);
        List<Primitive> halves = PrimitiveCollector.primitivesOf(lens);
        Primitive ball = PrimitiveCollector.primitivesOf(new Sphere("", MIDDLE, 0.7, ColouredSurface.DEFAULT))
                .get(0);
        assertThat(halves).hasSize(2);
        SplittableRandom random = new SplittableRandom(1704);
        int met = 0;
        for (int i = 0; i < 2000; i++) {
            Vector3d start = vector(random).normalize(away).add(MIDDLE);
            Vector3d d = vector(random).mul(0.7).add(MIDDLE).sub(start).normalize();
            Ray ray = Ray.from(start.x, start.y, start.z, d.x, d.y, d.z, 0);
            double first = halves.get(0).distance(ray, Primitive.NO_HIT);
            double second = halves.get(1).distance(ray, Primitive.NO_HIT);
            double distance = ball.distance(ray, Primitive.NO_HIT);
            double clearance = clearance(ray);
            if (distance == Primitive.NO_HIT || clearance < 1e-3) {
                continue;
            }
            met++;
            assertThat(Math.min(first, second)).isCloseTo(distance, within(error));
            Hit hit = halves.get(first < second ? 0 : 1).hit(ray, Math.min(first, second));
            Hit expected = ball.hit(ray, distance);
            assertThat(new Vector3d(hit.normalX, hit.normalY, hit.normalZ)
                            .distance(expected.normalX, expected.normalY, expected.normalZ))
                    .isLessThan(10 * error);
        }
        assertThat(met).isGreaterThan(500);
    }

    /** How far inside the ball a line passes, so that rounding is not enlarged. */
    private static double clearance(Ray ray) {
        Vector3d to = new Vector3d(MIDDLE).sub(ray.x, ray.y, ray.z);
        return 0.7 - to.cross(ray.dx, ray.dy, ray.dz).length();
    }

    private static Vector3d vector(SplittableRandom random) {
        return new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    @Test
    void refusesFacesThatMeet() {
        assertThatThrownBy(() -> lens(0.1, -0.5, 0))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining("edgeThickness must be above 0.26794")
                .hasMessageContaining("was 0.1");
        assertThatThrownBy(() -> lens(0, 0, 0)).hasMessageContaining("edgeThickness must be above 0,");
        assertThatThrownBy(() -> lens(0, 1.01, 0))
                .hasMessageContaining("frontCurvature must be from -1 to 1, was 1.01");
        assertThat(lens(0.27, -0.5, 0).edgeThickness()).isEqualTo(0.27);
    }
}
