package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.surface.ColouredSurface;

/** An object that is shifted, against its primitives: all of them have moved, and nothing else about them. */
class ShiftedTest {

    private static final Vector3dc SHIFT = new Vector3d(0.25, -3, 1.5);

    static Stream<Class<?>> types() {
        return Descriptions.members(SceneObject.class).stream();
    }

    /** A usual object of a type; those that hold nothing hold something. */
    private static SceneObject sample(Class<?> type) {
        return type == Group.class
                ? new Group("group", List.of(Sphere.DEFAULT, Box.DEFAULT))
                : (SceneObject) Descriptions.standard(type);
    }

    @ParameterizedTest
    @MethodSource("types")
    void allPrimitivesMoveByTheShift(Class<?> type) {
        List<Primitive> before = PrimitiveCollector.primitivesOf(sample(type));
        List<Primitive> after = PrimitiveCollector.primitivesOf(sample(type).shifted(SHIFT));
        assertThat(after).hasSameSizeAs(before);
        for (int i = 0; i < before.size(); i++) {
            check(before.get(i).bounds(), after.get(i).bounds());
        }
    }

    private static void check(Bounds before, Bounds after) {
        if (before != null) {
            assertThat(low(after)).matches(low -> low.distance(low(before).add(SHIFT)) < 1e-12, "the low corner");
            assertThat(high(after)).matches(high -> high.distance(high(before).add(SHIFT)) < 1e-12, "the high corner");
        }
    }

    private static Vector3d low(Bounds bounds) {
        return new Vector3d(bounds.minX(), bounds.minY(), bounds.minZ());
    }

    private static Vector3d high(Bounds bounds) {
        return new Vector3d(bounds.maxX(), bounds.maxY(), bounds.maxZ());
    }

    /** Its primitive has no bounds. */
    @Test
    void aPlaneMovesWithItsPoint() {
        Plane moved = (Plane) Plane.DEFAULT.shifted(SHIFT);
        assertThat(moved.point()).isEqualTo(new Vector3d(0.25, -4, 1.5));
        assertThat(moved.normal()).isEqualTo(Plane.DEFAULT.normal());
    }

    /** What is hidden has no primitives. */
    @Test
    void whatIsHiddenMoves() {
        assertThat(Hidden.DEFAULT.shifted(SHIFT)).isEqualTo(new Hidden(Sphere.DEFAULT.shifted(SHIFT)));
    }

    /** A vector from the corner is no place, nor are the axes of an ellipsoid. */
    @Test
    void lengthsAndDirectionsStay() {
        Parallelogram sheet = (Parallelogram) Parallelogram.DEFAULT.shifted(SHIFT);
        assertThat(sheet.spanU()).isEqualTo(Parallelogram.DEFAULT.spanU());
        assertThat(sheet.spanV()).isEqualTo(Parallelogram.DEFAULT.spanV());
        assertThat(((Ellipsoid) Ellipsoid.DEFAULT.shifted(SHIFT)).semiAxes()).isEqualTo(Ellipsoid.DEFAULT.semiAxes());
    }

    /** As a person adds: in binary it is 0.30000000000000004. */
    @Test
    void sumsAreThoseOfTheDecimals() {
        Sphere sphere = new Sphere("ball", new Vector3d(0.1, 1e-9, 7), 1, ColouredSurface.DEFAULT);
        Vector3dc centre = ((Sphere) sphere.shifted(new Vector3d(0.2, 0, -7))).centre();
        assertThat(centre.x()).isEqualTo(0.3);
        assertThat(centre.y()).isEqualTo(1e-9);
        assertThat(centre.z()).isCloseTo(0, within(0.0));
    }
}
