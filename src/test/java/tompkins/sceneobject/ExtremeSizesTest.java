package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.fuzz.RandomStudio;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.search.RandomAims;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** Hits of shapes whose squares are no numbers any more, or 0. */
class ExtremeSizesTest {

    private static final Surface COLOURED = ColouredSurface.DEFAULT;

    /** Powers of ten: lengths from 1e-300 to 1e300. */
    private static final int[] EXPONENTS =
            IntStream.rangeClosed(-12, 12).map(exponent -> 25 * exponent).toArray();

    private final RandomAims aims = new RandomAims(3);

    @ParameterizedTest
    @CsvSource({"1e200, 0, 0, 1", "1e200, 0.6, 0, 0.8", "1e154, 0, 1, 0", "1e300, 0, 0, -1", "1e-170, 0, 0.8, -0.6"})
    void aSphereIsMetFromInside(double radius, double dx, double dy, double dz) {
        Primitive sphere = PrimitiveCollector.primitivesOf(new Sphere("", new Vector3d(), radius, COLOURED))
                .get(0);
        Ray ray = Ray.from(0, 0, 0, dx, dy, dz, 0);
        double distance = sphere.distance(ray, Primitive.NO_HIT);
        assertThat(distance / radius).isCloseTo(1, within(1e-15));
        Hit hit = sphere.hit(ray, distance);
        assertThat(hit.normalX).isCloseTo(dx, within(1e-15));
        assertThat(hit.normalY).isCloseTo(dy, within(1e-15));
        assertThat(hit.normalZ).isCloseTo(dz, within(1e-15));
    }

    static Stream<Class<?>> types() {
        return Descriptions.members(SceneObject.class).stream();
    }

    @ParameterizedTest
    @MethodSource("types")
    void normalsAreUnitVectorsAtEverySize(Class<?> type) {
        for (int seed = 0; seed < 12; seed++) {
            SceneObject object = RandomStudio.object(seed, type, COLOURED);
            for (int exponent : EXPONENTS) {
                checkNormals(object, Math.pow(10, exponent));
            }
        }
    }

    @Test
    void normalsOfSlenderAndFlatShapesAreUnitVectors() {
        int hits = 0;
        for (int exponent : EXPONENTS) {
            double length = Math.pow(10, exponent);
            for (int other : EXPONENTS) {
                double width = Math.pow(10, other);
                hits += checkNormals(
                        new Cylinder("", new Vector3d(), new Vector3d(0, 0, length), width, true, COLOURED), 1);
                hits += checkNormals(
                        new Cone("", new Vector3d(0, 0, length), new Vector3d(), width, true, COLOURED), 1);
                hits += checkNormals(
                        new Box("", new Vector3d(-width), new Vector3d(width, width, length), COLOURED), 1);
                hits += checkNormals(
                        new Parallelogram(
                                "", new Vector3d(), new Vector3d(length, 0, 0), new Vector3d(0, width, 0), COLOURED),
                        1);
            }
        }
        assertThat(hits).isGreaterThan(10_000);
    }

    /** Looks at hits of rays from in and around the primitives of an object; how many there are. */
    private int checkNormals(SceneObject object, double scale) {
        int hits = 0;
        for (Primitive primitive : primitives(object, scale)) {
            for (int i = 0; i < 24; i++) {
                // half of them at whatever distance from the origin, where all these shapes have an end
                Vector3d start = i % 2 == 0
                        ? aims.placeIn(primitive)
                        : aims.vector(Math.pow(10, EXPONENTS[(int) aims.mix(0, EXPONENTS.length)]));
                Vector3d direction = aims.vector(1).normalize();
                if (i % 4 < 2) {
                    // along an axis, so that ends are met, too
                    direction.set(0, 0, direction.z > 0 ? 1 : -1);
                }
                Ray ray = Ray.from(start.x, start.y, start.z, direction.x, direction.y, direction.z, 0);
                double distance = primitive.distance(ray, Double.MAX_VALUE);
                if (distance < Primitive.NO_HIT) {
                    hits++;
                    Hit hit = primitive.hit(ray, distance);
                    assertThat(new Vector3d(hit.normalX, hit.normalY, hit.normalZ).length())
                            .as("length of a normal of %s, %g times as large", object, scale)
                            .isCloseTo(1, within(1e-12));
                }
            }
        }
        return hits;
    }

    /** The first primitives of an object; none if it refuses to be of that size. */
    private static List<Primitive> primitives(SceneObject object, double scale) {
        PrimitiveCollector collector = new PrimitiveCollector();
        try {
            object.addTo(collector, new Placement(scale, new Matrix3d(), new Vector3d()));
        } catch (ArithmeticException | InvalidPropertyException beyondNumbers) {
            return List.of();
        }
        List<Primitive> all = collector.primitives(0);
        return all.subList(0, Math.min(4, all.size()));
    }
}
