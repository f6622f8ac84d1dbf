package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.primitive.Bounds;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.search.LightBufferProjection.Rectangle;
import tompkins.surface.ColouredSurface;

/** What a lamp sees in a direction stands in the cell of the direction, and little else is taken for it. */
class LightBufferTest {

    private static final int RAYS = 200;
    private static final double RADIUS = 0.02;
    private static final Vector3dc LAMP = new Vector3d(0, 0, 10);

    private final RandomAims aims = new RandomAims(5);

    /** A lamp anywhere: what can throw a shadow towards it is seen where the shadow lies. */
    @Test
    void whatALineFromTheLampMeetsIsSeenThere() {
        int hits = 0;
        for (Primitive primitive : QuickRejectionTest.primitives().toList()) {
            Vector3d lamp = aims.vector(60);
            LightBufferProjection view =
                    primitive.bounds() == null ? null : LightBufferProjection.of(lamp, lamp, primitive.bounds());
            if (view == null) {
                continue;
            }
            LightBuffer cells = LightBuffer.of(view, List.of(primitive));
            for (int i = 0; i < RAYS; i++) {
                Ray ray = towards(lamp, place(primitive));
                double distance = primitive.distance(ray, Primitive.NO_HIT);
                if (distance < Primitive.NO_HIT) {
                    hits++;
                    assertThat(isSeen(view, cells, ray, distance))
                            .as(primitive.description())
                            .isTrue();
                }
            }
        }
        assertThat(hits).isGreaterThan(3000);
    }

    /** Most rays to the box of a rod miss it: here a place on its axis. */
    private Vector3d place(Primitive primitive) {
        Vector3d axis = primitive instanceof CylinderPrimitive rod ? rod.longAxis() : null;
        return axis == null
                ? aims.placeIn(primitive)
                : primitive.bounds().centre().fma(aims.mix(-0.5, 0.5), axis, new Vector3d());
    }

    /** A ball of radius 0.02, seen from a distance of 10, is a spot of slopes of 1/500 to each side. */
    @Test
    void ballIsASmallSpot() {
        Primitive ball = only(new Sphere("ball", new Vector3d(), RADIUS, ColouredSurface.DEFAULT));

        assertThat(isSeen(ball, 0.0019, -0.0019, 9.99)).isTrue();
        assertThat(isSeen(ball, 0, 0.0021, 9.99)).isFalse();
        assertThat(isSeen(ball, -0.0021, 0, 9.99)).isFalse();
        assertThat(isSeen(ball, 0, 0, 9.97)).as("before the ball").isFalse();
    }

    /** A rod is a strip, whatever its direction: what lies in its box, but beside the rod, is not taken for it. */
    @Test
    void rodIsANarrowStrip() {
        for (double angle = 0.1; angle < Math.PI; angle += 0.2) {
            double cosine = Math.cos(angle);
            double sine = Math.sin(angle);
            Vector3d end = new Vector3d(3 * cosine, 3 * sine, 0);
            Primitive rod =
                    only(new Cylinder("rod", end.negate(new Vector3d()), end, RADIUS, false, ColouredSurface.DEFAULT));
            int besideSeen = 0;
            for (double along = -0.2; along <= 0.2; along += 0.01) {
                for (double side : new double[] {-1, 1}) {
                    assertThat(isSeen(
                                    rod,
                                    along * cosine - side * 0.0019 * sine,
                                    along * sine + side * 0.0019 * cosine,
                                    11))
                            .isTrue();
                    besideSeen +=
                            isSeen(rod, along * cosine - side * 0.02 * sine, along * sine + side * 0.02 * cosine, 11)
                                    ? 1
                                    : 0;
                }
            }
            // three cells away
            assertThat(besideSeen).as("at angle %s", angle).isZero();
        }
    }

    /** In a scene that is seen under slopes of up to 0.43. */
    private static boolean isSeen(Primitive primitive, double x, double y, double distance) {
        LightBufferProjection view = LightBufferProjection.of(LAMP, LAMP, new Bounds(-3, -3, -3, 3, 3, 3));
        Ray ray = towards(LAMP, new Vector3d(10 * x, 10 * y, 0));
        return isSeen(view, LightBuffer.of(view, List.of(primitive)), ray, distance);
    }

    private static boolean isSeen(LightBufferProjection view, LightBuffer cells, Ray fromLamp, double distance) {
        int part = view.part(-fromLamp.dx, -fromLamp.dy, -fromLamp.dz, 0);
        int cell = LightBufferProjection.cell(part);
        return IntStream.range(cells.first(cell), cells.end(cell))
                .mapToLong(cells::entry)
                .anyMatch(entry -> BufferEntry.isSeen(entry, BufferEntry.place(part))
                        && !BufferEntry.isFarther(entry, BufferEntry.distance(distance)));
    }

    /** All places of a cell against all kinds of rectangles. */
    @Test
    void entryTellsThePlacesInItsRectangle() {
        Random random = new Random(1);
        int column = 5;
        int row = 120;
        for (int round = 0; round < 100; round++) {
            int[] columns = {random.nextInt(-50, 64), random.nextInt(64, 180)};
            int[] rows = {random.nextInt(-50, 64), random.nextInt(64, 180)};
            int left = column * LightBufferProjection.PARTS;
            int top = row * LightBufferProjection.PARTS;
            long entry = BufferEntry.of(
                    1.5f,
                    new Rectangle(left + columns[0], left + columns[1], top + rows[0], top + rows[1]),
                    column,
                    row);
            for (int y = 0; y < LightBufferProjection.PARTS; y++) {
                for (int x = 0; x < LightBufferProjection.PARTS; x++) {
                    assertThat(BufferEntry.isSeen(entry, BufferEntry.place(top + y << Short.SIZE | left + x)))
                            .isEqualTo(columns[0] <= x && x <= columns[1] && rows[0] <= y && y <= rows[1]);
                }
            }
            assertThat(BufferEntry.isFarther(entry, BufferEntry.distance(1.4999)))
                    .isTrue();
            assertThat(BufferEntry.isFarther(entry, BufferEntry.distance(1.5))).isFalse();
        }
    }

    /** Three thousand balls behind each other: a ray would ask them one by one. */
    @Test
    void crowdInOneCellIsLeftToTheTree() {
        Random random = new Random(2);
        List<Primitive> crowd = IntStream.range(0, 3000)
                .mapToObj(i -> only(new Sphere(
                        "ball", new Vector3d(0, 0, random.nextDouble(-3, 3)), 0.001, ColouredSurface.DEFAULT)))
                .toList();
        LightBufferProjection view = LightBufferProjection.of(LAMP, LAMP, new Bounds(-3, -3, -3, 3, 3, 3));

        assertThat(LightBuffer.of(view, crowd)).isNull();
        assertThat(LightBuffer.of(view, crowd.subList(0, 900))).isNotNull();
    }

    private static Primitive only(SceneObject object) {
        return PrimitiveCollector.primitivesOf(object).get(0);
    }

    private static Ray towards(Vector3dc start, Vector3dc target) {
        Vector3d d = target.sub(start, new Vector3d()).normalize();
        return Ray.from(start.x(), start.y(), start.z(), d.x, d.y, d.z, 0);
    }
}
