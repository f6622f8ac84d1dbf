package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.primitive.Bounds;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;

/** What a lamp sees in a direction stands in the cell of the direction, and little else is taken for it. */
class LightBufferTest {

    private static final int RAYS = 200;
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

    private static Ray towards(Vector3dc start, Vector3dc target) {
        Vector3d d = target.sub(start, new Vector3d()).normalize();
        return Ray.from(start.x(), start.y(), start.z(), d.x, d.y, d.z, 0);
    }
}
