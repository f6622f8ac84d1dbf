package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.PixelPicture;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;
import tompkins.search.RandomAims;
import tompkins.surface.Clear;
import tompkins.surface.ColouredSurface;
import tompkins.surface.CutOut;
import tompkins.surface.Surface;
import tompkins.surface.Tiling;

/** Placed objects, coordinates at known points, tight bounds, and shadows of surfaces with holes. */
class ShapeGeometryTest {

    private static final Surface TILED = Tiling.DEFAULT;
    private static final double SMALL = 1e-12;

    private final RandomAims aims = new RandomAims(21);

    /** Each object scaled by 2.5 and moved, and the same object described where it then is. */
    static Stream<Arguments> scaledObjects() {
        Vector3d middle = new Vector3d(1, 2, 4);
        List<SceneObject> there = SampleShapes.all(
                        middle.mul(2.5, new Vector3d()).add(1, -2, 3), 2 * 2.5, TILED)
                .toList();
        List<SceneObject> here = SampleShapes.all(middle, 2, TILED).toList();
        return IntStream.range(0, here.size()).mapToObj(i -> Arguments.of(here.get(i), there.get(i)));
    }

    @ParameterizedTest
    @MethodSource("scaledObjects")
    void scaledAndMovedObjectsAreThoseDescribedThere(SceneObject object, SceneObject there) {
        SceneObject placed = new Placed("", object, 2.5, new Vector3d(0, 0, 1), 0, new Vector3d(1, -2, 3));
        List<Primitive> ones = PrimitiveCollector.primitivesOf(placed);
        List<Primitive> others = PrimitiveCollector.primitivesOf(there);
        assertThat(ones).hasSameSizeAs(others);
        int hits = 0;
        for (int i = 0; i < 600; i++) {
            Ray ray = EdgeRays.towards(aims.vector(30), aims.vector(6).add(2, 2, 12));
            for (int k = 0; k < ones.size(); k++) {
                double distance = ones.get(k).distance(ray, Primitive.NO_HIT);
                double expected = others.get(k).distance(ray, Primitive.NO_HIT);
                if (expected == Primitive.NO_HIT) {
                    assertThat(distance).isEqualTo(Primitive.NO_HIT);
                    continue;
                }
                hits++;
                assertThat(distance).isCloseTo(expected, within(SMALL * 100));
                SurfaceCoordinates one = ones.get(k).hit(ray, distance).coordinates;
                SurfaceCoordinates other = others.get(k).hit(ray, expected).coordinates;
                assertThat(one.u()).isCloseTo(other.u(), within(1e-9));
                assertThat(one.v()).isCloseTo(other.v(), within(1e-9));
                assertThat(one.uX() + one.uY() - one.uZ())
                        .isCloseTo(other.uX() + other.uY() - other.uZ(), within(1e-9));
                assertThat(one.vX() + one.vY() - one.vZ())
                        .isCloseTo(other.vX() + other.vY() - other.vZ(), within(1e-9));
            }
        }
        assertThat(hits).isGreaterThan(60);
    }

    @Test
    void planesMeasureLengthsFromTheirPoint() {
        Plane floor = new Plane("", new Vector3d(3, -1, 7), new Vector3d(0, 2, 0), TILED);
        assertCoordinates(floor, new Vector3d(5.5, 4, 6), new Vector3d(0, -1, 0), 2.5, -1);
        assertCoordinates(floor, new Vector3d(5.5, 1, 6), new Vector3d(0.5, -1, -0.25), 3.5, -1.5);
        Placed large = new Placed("", floor, 2, new Vector3d(0, 1, 0), 0, new Vector3d(0, 0, 1));
        // the point is (6, -2, 15) then
        assertCoordinates(large, new Vector3d(8, 4, 10), new Vector3d(0, -1, 0), 1, -2.5);
    }

    @Test
    void coordinatesOfKnownPoints() {
        Sphere ball = new Sphere("", new Vector3d(1, 2, 3), 2, TILED);
        assertCoordinates(ball, new Vector3d(1, 2, -9), new Vector3d(0, 0, 1), 0.5, 0.5);
        assertCoordinates(ball, new Vector3d(9, 2, 3), new Vector3d(-1, 0, 0), 0.75, 0.5);
        assertCoordinates(ball, new Vector3d(-9, 2, 3), new Vector3d(1, 0, 0), 0.25, 0.5);
        assertCoordinates(
                ball, new Vector3d(1, 2, -9), new Vector3d(0, Math.sqrt(2), 10 + 2 - Math.sqrt(2)), 0.5, 0.75);
        Box box = new Box("", new Vector3d(1, 2, 3), new Vector3d(3, 6, 11), TILED);
        assertCoordinates(box, new Vector3d(-5, 3, 5), new Vector3d(1, 0, 0), 0.75, 0.25);
        assertCoordinates(box, new Vector3d(1.5, 9, 5), new Vector3d(0, -1, 0), 0.25, 0.25);
        assertCoordinates(box, new Vector3d(2.5, 5, -9), new Vector3d(0, 0, 1), 0.75, 0.75);
        Cylinder rod = new Cylinder("", new Vector3d(1, 0, 0), new Vector3d(1, 4, 0), 2, true, TILED);
        assertCoordinates(rod, new Vector3d(1, 1, -9), new Vector3d(0, 0, 1), 0.5, 0.25);
        assertCoordinates(rod, new Vector3d(9, 1, 0), new Vector3d(-1, 0, 0), 0.75, 0.25);
        assertCoordinates(rod, new Vector3d(2, 9, 1), new Vector3d(0, -1, 0), 0.75, 0.75);
        assertCoordinates(rod, new Vector3d(0, -9, 0.5), new Vector3d(0, 1, 0), 0.25, 0.375);
        Cone cone = new Cone("", new Vector3d(1, 4, 0), new Vector3d(1, 0, 0), 2, false, TILED);
        assertCoordinates(cone, new Vector3d(9, 1, 0), new Vector3d(-1, 0, 0), 0.75, 0.25);
        Disc disc = new Disc("", new Vector3d(1, 2, 3), new Vector3d(0, 0, 1), 2, TILED);
        assertCoordinates(disc, new Vector3d(2, 2.5, 0), new Vector3d(0, 0, 1), 0.25, 0.625);
        Triangle triangle =
                new Triangle("", new Vector3d(0, 0, 5), new Vector3d(4, 0, 5), new Vector3d(0, 2, 5), TILED);
        assertCoordinates(triangle, new Vector3d(1, 0.5, 0), new Vector3d(0, 0, 1), 0.25, 0.25);
    }

    /** Neighbours in a mesh leave no gap: corners and sides belong to a triangle, whatever the sign of a zero is. */
    @ParameterizedTest
    @CsvSource({"1, 1", "1, -1", "-1, 1", "-1, -1"})
    void cornersAndSidesBelongToATriangle(double x, double y) {
        Primitive triangle = only(
                new Triangle("", new Vector3d(0, 0, 4), new Vector3d(2 * x, 0, 4), new Vector3d(0, 2 * y, 4), TILED));

        assertThat(distanceFrom(0, 0, triangle)).isEqualTo(4);
        assertThat(distanceFrom(2 * x, 0, triangle)).isEqualTo(4);
        assertThat(distanceFrom(0, 2 * y, triangle)).isEqualTo(4);
        assertThat(distanceFrom(x, 0, triangle)).isEqualTo(4);
        assertThat(distanceFrom(0, y, triangle)).isEqualTo(4);
        assertThat(distanceFrom(x, y, triangle)).isEqualTo(4);
        assertThat(distanceFrom(-Math.ulp(1.0) * x, y, triangle)).isEqualTo(Primitive.NO_HIT);
        assertThat(distanceFrom(x, -Math.ulp(1.0) * y, triangle)).isEqualTo(Primitive.NO_HIT);
        assertThat(distanceFrom(x, 1.000000000000001 * y, triangle)).isEqualTo(Primitive.NO_HIT);
    }

    /** There u and v are sums of zeros that are all negative. */
    @Test
    void theCornerOfASlantingTriangleBelongsToIt() {
        Primitive triangle =
                only(new Triangle("", new Vector3d(0, 0, 4), new Vector3d(-1, -1, 3), new Vector3d(-1, 1, 4), TILED));

        assertThat(distanceFrom(0, 0, triangle)).isEqualTo(4);
    }

    private static double distanceFrom(double x, double y, Primitive primitive) {
        return primitive.distance(Ray.from(x, y, 0, 0, 0, 1, 0), Primitive.NO_HIT);
    }

    @Test
    void patternsTurnWithACylinderAboutItsAxis() {
        Cylinder rod = new Cylinder("", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), 1, true, TILED);
        // an eighth of a turn, which takes the front (-z) towards the left (-x)
        SceneObject turned = new Placed("", rod, 1, new Vector3d(0, 1, 0), 45, new Vector3d());
        assertCoordinates(turned, new Vector3d(0, 0.5, -9), new Vector3d(0, 0, 1), 0.625, 0.75);
    }

    /** x points to the right, y up and z away from the camera: there, right x up points away from who looks. */
    @ParameterizedTest
    @MethodSource("closedShapes")
    void picturesAreNotMirroredSeenFromOutside(SceneObject object) {
        for (SceneObject seen :
                List.of(object, new Placed("", object, 2, new Vector3d(3, -1, 2), 77, new Vector3d()))) {
            int hits = 0;
            for (int i = 0; i < 300; i++) {
                Ray ray = EdgeRays.towards(aims.vector(30).add(0, 0, -60), aims.vector(2));
                for (Primitive primitive : PrimitiveCollector.primitivesOf(seen)) {
                    double distance = primitive.distance(ray, Primitive.NO_HIT);
                    if (distance == Primitive.NO_HIT) {
                        continue;
                    }
                    Hit hit = primitive.hit(ray, distance);
                    Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
                    SurfaceCoordinates at = hit.coordinates;
                    Vector3d right = new Vector3d(at.uX(), at.uY(), at.uZ());
                    right.sub(new Vector3d(normal).mul(right.dot(normal)));
                    Vector3d up = new Vector3d(at.vX(), at.vY(), at.vZ());
                    up.sub(new Vector3d(normal).mul(up.dot(normal)));
                    assertThat(right.cross(up).normalize().dot(normal)).isCloseTo(-1, within(1e-9));
                    hits++;
                }
            }
            assertThat(hits).isPositive();
        }
    }

    /** A mesh has no round of its own: its coordinates are those of each triangle. */
    static Stream<SceneObject> closedShapes() {
        return Stream.concat(
                SampleShapes.closed(new Vector3d(), 2, TILED)
                        .filter(shape -> !shape.description().equals("mesh")),
                Stream.of(new Disc("", new Vector3d(), new Vector3d(0.5, 1, -1), 2, TILED)));
    }

    private static void assertCoordinates(SceneObject object, Vector3dc origin, Vector3dc d, double u, double v) {
        Ray ray = EdgeRays.towards(origin, d.add(origin, new Vector3d()));
        Primitive primitive = only(object);
        SurfaceCoordinates found = primitive.hit(ray, primitive.distance(ray, Primitive.NO_HIT)).coordinates;
        assertThat(found.u()).as("u of %s", object).isCloseTo(u, within(SMALL));
        assertThat(found.v()).as("v of %s", object).isCloseTo(v, within(SMALL));
    }

    static Stream<SceneObject> shapes() {
        return SampleShapes.all(new Vector3d(1, -2, 3), 2, TILED);
    }

    /** Least values and boxes touch the object: neither too small nor needlessly large. */
    @ParameterizedTest
    @MethodSource("shapes")
    void boundsAreTight(SceneObject shape) {
        Primitive primitive = only(shape);
        Bounds box = primitive.bounds();
        Vector3d low = new Vector3d(Double.POSITIVE_INFINITY);
        Vector3d high = new Vector3d(Double.NEGATIVE_INFINITY);
        Vector3d[] normals = new Vector3d[20];
        double[] least = new double[normals.length];
        for (int k = 0; k < normals.length; k++) {
            normals[k] = aims.vector(1).normalize().mul(0.5 + k);
            least[k] = Double.POSITIVE_INFINITY;
        }
        for (int i = 0; i < 60_000; i++) {
            Vector3d target = new Vector3d(
                    aims.mix(box.minX(), box.maxX()),
                    aims.mix(box.minY(), box.maxY()),
                    aims.mix(box.minZ(), box.maxZ()));
            Ray ray = EdgeRays.towards(aims.vector(1).normalize().mul(20).add(target), target);
            double distance = primitive.distance(ray, Primitive.NO_HIT);
            if (distance < Primitive.NO_HIT) {
                Hit hit = primitive.hit(ray, distance);
                Vector3d place = new Vector3d(hit.x, hit.y, hit.z);
                low.min(place);
                high.max(place);
                for (int k = 0; k < normals.length; k++) {
                    least[k] = Math.min(least[k], normals[k].dot(place));
                }
            }
        }
        // the box of a disc is that of the square around it
        double slack = shape instanceof Disc ? 1 : 0.5;
        assertThat(low.distance(box.minX(), box.minY(), box.minZ())).isLessThan(slack);
        assertThat(high.distance(box.maxX(), box.maxY(), box.maxZ())).isLessThan(slack);
        for (int k = 0; k < normals.length; k++) {
            Vector3d n = normals[k];
            double claimed = primitive.minimumAlong(n.x, n.y, n.z);
            assertThat(claimed).isLessThanOrEqualTo(least[k] + 1e-9);
            assertThat(claimed).isGreaterThan(least[k] - slack * n.length());
            assertThat(primitive.conservativeMinimumAlong(n.x, n.y, n.z))
                    .isBetween(claimed - 1e-6 * n.length(), claimed + 1e-6 * n.length());
        }
    }

    /** A narrow bundle of rays along an end of a cylinder, or the base of a cone, has planes nearly across the axis. */
    @ParameterizedTest
    @CsvSource({"1e-6", "1e-8", "3e-9", "1e-12"})
    void leastValuesHoldTheRimsOfEnds(double tilt) {
        Vector3d start = new Vector3d(0, 0, 5);
        Vector3d end = new Vector3d(0, 0, 7);
        double expected = 5 - 2.5 * tilt;
        Cylinder rod = new Cylinder("", start, end, 2.5, true, ColouredSurface.DEFAULT);
        assertThat(only(rod).minimumAlong(tilt, 0, 1)).isCloseTo(expected, within(2e-15));
        Cone cone = new Cone("", end, start, 2.5, false, ColouredSurface.DEFAULT);
        assertThat(only(cone).minimumAlong(0, tilt, 1)).isCloseTo(expected, within(2e-15));
    }

    private static final PixelPicture HALF_DARK =
            new PixelPicture("half.png", 2, 1, new float[] {0, 0, 0, 1, 1, 1, 1, 1}, new byte[0]);

    private static Primitive sheet(Surface dark, Surface bright) {
        Surface cut = new CutOut(HALF_DARK, dark, bright);
        return only(new Parallelogram("", new Vector3d(0, 0, 5), new Vector3d(2, 0, 0), new Vector3d(0, 2, 0), cut));
    }

    @Test
    void shadowsFallWhereThePictureIsOpaque() {
        Primitive sheet = sheet(ColouredSurface.DEFAULT, Clear.DEFAULT);
        Ray dark = EdgeRays.towards(new Vector3d(0.5, 1, 0), new Vector3d(0.5, 1, 5));
        Ray bright = EdgeRays.towards(new Vector3d(1.5, 1, 0), new Vector3d(1.5, 1, 5));
        assertThat(sheet.shadows(dark, 10)).isTrue();
        assertThat(sheet.shadows(dark, 4)).isFalse();
        assertThat(sheet.shadows(bright, 10)).isFalse();
        assertThat(sheet.shadows(EdgeRays.towards(new Vector3d(3, 1, 0), new Vector3d(3, 1, 5)), 10))
                .isFalse();
        Primitive other = sheet(Clear.DEFAULT, ColouredSurface.DEFAULT);
        assertThat(other.shadows(dark, 10)).isFalse();
        assertThat(other.shadows(bright, 10)).isTrue();
    }

    /** Light that gets in through the clear half of a ball and meets the dark half behind. */
    @Test
    void shadowsFallFromTheFarSideOfAHollowBall() {
        Surface cut = new CutOut(HALF_DARK, ColouredSurface.DEFAULT, Clear.DEFAULT);
        // dark where u < 1/2, which is the side of negative x
        Primitive ball = only(new Sphere("", new Vector3d(), 1, cut));
        Ray fromTheRight = EdgeRays.towards(new Vector3d(5, 0.1, 0.2), new Vector3d(0, 0.1, 0.2));
        assertThat(ball.shadows(fromTheRight, 10)).isTrue();
        assertThat(ball.shadows(fromTheRight, 5.5))
                .as("the light stands inside")
                .isFalse();
        Ray onTheRight = EdgeRays.towards(new Vector3d(0.5, 0.1, 5), new Vector3d(0.5, 0.1, 0));
        assertThat(ball.shadows(onTheRight, 20)).isFalse();
        assertThat(ball.shadows(EdgeRays.towards(new Vector3d(-0.5, 0.1, 5), new Vector3d(-0.5, 0.1, 0)), 20))
                .isTrue();
    }

    /** What rounding cannot tell from a point or a line faces the ray. */
    @Test
    void hitsOfVanishingShapesHaveANormal() {
        Vector3d far = new Vector3d(0, 0, 0x1p68);
        Cylinder rod = new Cylinder("", new Vector3d(-1, 0, 0x1p68), new Vector3d(1, 0, 0x1p68), 1e-3, false, TILED);
        for (SceneObject tiny : List.of(new Sphere("", far, 1e-3, TILED), rod)) {
            Hit hit = only(tiny).hit(EdgeRays.towards(new Vector3d(), far), 0x1p68);
            assertThat(new Vector3d(hit.normalX, hit.normalY, hit.normalZ).distance(0, 0, -1))
                    .isZero();
        }
    }

    private static Primitive only(SceneObject object) {
        return PrimitiveCollector.primitivesOf(object).get(0);
    }
}
