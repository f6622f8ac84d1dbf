package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.EdgeRays;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;

/** Sheets that image points: where the equations of their images say, for all rays and any aperture. */
class ImagingSheetsTest {

    private static final double ROUNDING = 1e-12;

    private final SplittableRandom random = new SplittableRandom(20090106);

    private Vector3d vector(double reach) {
        return new Vector3d(
                random.nextDouble(-reach, reach), random.nextDouble(-reach, reach), random.nextDouble(-reach, reach));
    }

    static Primitive primitive(SceneObject sheet) {
        return PrimitiveCollector.primitivesOf(sheet).get(0);
    }

    /** The ray behind a sheet. */
    private static Ray beyond(Primitive sheet, Ray ray) {
        double distance = sheet.distance(ray, Primitive.NO_HIT);
        return sheet.surface().respond(ray, sheet.hit(ray, distance), null).next();
    }

    private static Vector3d place(Ray ray) {
        return new Vector3d(ray.x, ray.y, ray.z);
    }

    private static Vector3d direction(Ray ray) {
        return new Vector3d(ray.dx, ray.dy, ray.dz);
    }

    /** How far a point is from the line of a ray. */
    private static double miss(Ray ray, Vector3dc point) {
        return point.sub(place(ray), new Vector3d()).cross(direction(ray)).length();
    }

    /** An image and its object, with q and q' along the ray: 1/q' = 1/q + 1/f and Q' - P = (Q - P) f/(f + q). */
    @ParameterizedTest
    @CsvSource({"2, 5", "2, 0.7", "-1.5, 4", "-1.5, 0.6", "3, -3.5", "1e3, 2"})
    void aLensImagesEveryPoint(double focalLength, double objectDistance) {
        Vector3d normal = new Vector3d(1, -2, 3).normalize();
        Vector3d centre = new Vector3d(0.3, 0.1, 6);
        Disc disc = new Disc("lens", new Vector3d(), normal, 4, new IdealLens(focalLength, 0.5, 0.5, 1));
        Primitive lens = primitive(new Placed("", disc, 1.5, new Vector3d(0, 1, 0), 0, centre));
        Vector3d across = new Vector3d(normal).cross(0, 1, 0).normalize();
        for (int i = 0; i < 200; i++) {
            double side = i % 2 == 0 ? 1 : -1;
            // what the ray would meet at Q goes on to Q'
            Vector3d object = new Vector3d(normal)
                    .mul(side * objectDistance)
                    .fma(random.nextDouble(-3, 3), across)
                    .add(centre);
            double factor = focalLength / (focalLength + objectDistance);
            Vector3d image = new Vector3d(object).sub(centre).mul(factor).add(centre);
            Vector3d onLens = vector(3);
            onLens.fma(-onLens.dot(normal), normal).add(centre);
            Vector3d start = new Vector3d(onLens)
                    .sub(object)
                    .mul(Math.signum(objectDistance) * 2)
                    .add(onLens);

            Ray next = beyond(lens, EdgeRays.towards(start, onLens));

            assertThat(miss(next, image)).isLessThan(ROUNDING * 100);
            assertThat(1 / (objectDistance * factor)).isCloseTo(1 / objectDistance + 1 / focalLength, within(ROUNDING));
            assertThat(direction(next).length()).isCloseTo(1, within(1e-15));
        }
    }

    /** What a ray would meet at the distance z before the sheet lies at eta z, moved by -z delta. */
    @ParameterizedTest
    @CsvSource({"2, 0, 0", "0.3, 0.2, -0.1", "-1, 0, 0", "-1.5, 0.4, 0.3", "20, -4, 0"})
    void lensletsImageEveryPoint(double eta, double deltaU, double deltaV) {
        Vector3d u = new Vector3d(0.8, 0.6, 0);
        Vector3d v = new Vector3d(-0.36, 0.48, 0.8);
        Vector3d normal = u.cross(v, new Vector3d());
        Primitive sheet = primitive(new Parallelogram(
                "sheet",
                u.mul(-9, new Vector3d()).fma(-6, v),
                u.mul(18, new Vector3d()),
                v.mul(12, new Vector3d()),
                new ConfocalLensletArray(eta, eta, deltaU, deltaV, 1)));
        for (int i = 0; i < 200; i++) {
            double z = random.nextDouble(2, 5);
            Vector3d object = new Vector3d(normal).mul(z).add(vector(1));
            z = object.dot(normal);
            Vector3d onSheet = vector(3);
            onSheet.fma(-onSheet.dot(normal), normal);
            Vector3d start = new Vector3d(onSheet).mul(3).fma(-2, object);
            Vector3d image = new Vector3d(object)
                    .fma((eta - 1) * z, normal)
                    .fma(-z * deltaU, u)
                    .fma(-z * deltaV, v);

            Ray next = beyond(sheet, EdgeRays.towards(start, onSheet));

            assertThat(miss(next, image)).isLessThan(ROUNDING * 100);
            assertThat(next.time).isEqualTo(-new Vector3d(onSheet).sub(start).length(), within(ROUNDING * 100));
        }
    }

    static Stream<Surface> sheets() {
        return Stream.of(
                new IdealLens(2, 0.5, 0.5, 1),
                new IdealLens(-0.3, 0.1, 0.9, 1),
                new ConfocalLensletArray(1.4, -0.6, 0.3, -0.2, 1),
                new ConfocalLensletArray(7, 7, 0, 0, 1),
                new ComplexRefraction(1, 90, 1),
                new ComplexRefraction(1.5, 40, 1));
    }

    /** The other side takes the same light back. */
    @ParameterizedTest
    @MethodSource("sheets")
    void lightGoesTheSameWayBack(Surface surface) {
        Disc disc = new Disc("sheet", new Vector3d(1, 2, 5), new Vector3d(0.3, -0.2, -1), 3, surface);
        Primitive sheet = primitive(disc);
        for (int i = 0; i < 200; i++) {
            Ray there = EdgeRays.towards(vector(2), vector(1.5).add(1, 2, 5));
            if (sheet.distance(there, Primitive.NO_HIT) == Primitive.NO_HIT) {
                continue;
            }
            Ray next = beyond(sheet, there);
            Vector3d far = direction(next).mul(3).add(place(next));
            Ray back = beyond(sheet, EdgeRays.towards(far, place(next)));
            assertThat(direction(back).add(direction(there)).length()).isLessThan(1e-13);
            assertThat(place(back).distance(place(next))).isLessThan(ROUNDING);
        }
    }

    @Test
    void sheetsThatImageAsPanesTurnNothing() {
        Vector3d middle = new Vector3d(0, 0, 5);
        Vector3d normal = new Vector3d(1, 2, -3);
        Primitive lenslets = primitive(new Disc("", middle, normal, 9, new ConfocalLensletArray(1, 1, 0, 0, 1)));
        Primitive lens = primitive(new Plane("", middle, normal, new IdealLens(1e20, 3, -2, 1)));
        for (int i = 0; i < 100; i++) {
            Ray ray = EdgeRays.towards(vector(1), vector(2).add(middle));
            assertThat(direction(beyond(lenslets, ray))).isEqualTo(direction(ray));
            assertThat(direction(beyond(lens, ray)).distance(direction(ray))).isLessThan(1e-15);
        }
    }

    /** Rays from a point at twice the focal length meet there again behind the lens, and part. */
    @Test
    void bundlesHaveNoWidthInAFocus() {
        Primitive lens =
                primitive(new Disc("", new Vector3d(0, 0, 4), new Vector3d(0, 0, 1), 9, new IdealLens(2, 0.5, 0.5, 1)));
        Ray ray = EdgeRays.towards(new Vector3d(), new Vector3d(0, 0, 1));
        ray.spread = 1e-3;
        Ray next = beyond(lens, ray);
        assertThat(next.widthAt(0)).isCloseTo(4e-3, within(1e-17));
        assertThat(next.widthAt(4)).isCloseTo(0, within(1e-17));
        assertThat(next.widthAt(10)).isCloseTo(6e-3, within(1e-17));
    }

    /** The area of directions that three neighbouring rays span, before and behind. */
    @ParameterizedTest
    @MethodSource("sheets")
    void bundlesOpenAsNeighbouringRaysDo(Surface surface) {
        Primitive sheet = primitive(new Disc("", new Vector3d(0, 0, 1), new Vector3d(0.1, 0.2, -1), 30, surface));
        double angle = 1e-6;
        for (int i = 0; i < 50; i++) {
            Vector3d onSheet = vector(0.6).mul(1, 1, 0).add(0, 0, 1);
            double onto = new Vector3d(onSheet).sub(0, 0, 1).dot(0.1, 0.2, -1);
            onSheet.z += onto;
            // rays from the sheet itself: their width does not count
            Vector3d d = onSheet.add(vector(0.2), new Vector3d()).normalize();
            Vector3d right = new Vector3d(d).cross(0, 1, 0).normalize();
            Vector3d up = new Vector3d(d).cross(right);
            Ray middle = fromSheet(onSheet, d);
            middle.spread = angle;
            Ray next = beyond(sheet, middle);
            Vector3d one = direction(beyond(sheet, fromSheet(onSheet, new Vector3d(d).fma(angle, right))));
            Vector3d other = direction(beyond(sheet, fromSheet(onSheet, new Vector3d(d).fma(angle, up))));
            double area =
                    one.sub(direction(next)).cross(other.sub(direction(next))).length();
            assertThat(next.spread).isCloseTo(Math.sqrt(area), within(1e-3 * angle));
        }
    }

    private static Ray fromSheet(Vector3dc onSheet, Vector3dc direction) {
        Vector3d start = direction.mul(-1e-7, new Vector3d()).add(onSheet);
        return EdgeRays.towards(start, direction.add(start, new Vector3d()));
    }

    /** Both sheets leave the colour and the frequency of light alone; what passes is the transmission. */
    @ParameterizedTest
    @MethodSource("dimming")
    void sheetsDimByTheirTransmission(Surface surface) {
        Primitive sheet = primitive(new Disc("", new Vector3d(0, 0, 5), new Vector3d(0, 0, -1), 9, surface));
        Ray ray = EdgeRays.towards(new Vector3d(), new Vector3d(0.1, 0.2, 1));
        Response response = surface.respond(ray, sheet.hit(ray, sheet.distance(ray, 9)), null);
        assertThat(response.factor().green()).isEqualTo(0.25);
        assertThat(response.light().brightest()).isZero();
        assertThat(response.next().throughput).isEqualTo(0.25);
        assertThat(response.next().frequency).isEqualTo(1);
        assertThat(response.next().directionLength).isEqualTo(1);
        assertThat(response.next().slowness).isEqualTo(1);
    }

    static Stream<Surface> dimming() {
        return Stream.of(
                new IdealLens(2, 0.5, 0.5, 0.25),
                new ConfocalLensletArray(2, 2, 0, 0, 0.25),
                new ConfocalLensletArray(1, 1, 0, 0, 0.25),
                new ComplexRefraction(1, 0, 0.25));
    }
}
