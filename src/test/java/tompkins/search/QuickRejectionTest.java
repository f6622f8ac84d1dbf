package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.fuzz.RandomStudio;
import tompkins.primitive.CapPrimitive;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.sceneobject.EdgeRays;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.surface.ColouredSurface;

/** What tells rays from a primitive without testing them never tells one that hits, and tells most that miss. */
class QuickRejectionTest {

    private static final int RAYS = 200;

    private final RandomAims aims = new RandomAims(3);

    static Stream<Primitive> primitives() {
        return Descriptions.members(SceneObject.class).stream()
                .flatMap(type -> Stream.of(1, 2, 3, 4)
                        .flatMap(seed ->
                                PrimitiveCollector.primitivesOf(
                                                RandomStudio.object(seed, type, ColouredSurface.DEFAULT))
                                        .stream()
                                        .limit(3)));
    }

    @Test
    void noRayThatHitsIsSurelyMissing() {
        for (Primitive primitive : primitives().toList()) {
            for (int i = 0; i < RAYS; i++) {
                Ray ray = aimed(primitive, aims.vector(30));
                boolean hits = primitive.distance(ray, Primitive.NO_HIT) < Primitive.NO_HIT;
                assertThat(hits && primitive.leavesConvexShape(startOf(ray), ray.dx, ray.dy, ray.dz))
                        .isFalse();
            }
        }
    }

    /**
     * Half of all directions lead out of a surface, and from none of them does a convex shape get in the way; the face
     * of a lens may be hollow.
     */
    @Test
    void rayThatLeavesAPrimitiveOutwardsSurelyMissesIt() {
        int outwards = 0;
        int inwards = 0;
        for (Primitive primitive : primitives().toList()) {
            for (int i = 0; i < RAYS; i++) {
                Ray ray = aimed(primitive, aims.vector(30));
                double distance = primitive.distance(ray, Primitive.NO_HIT);
                if (distance == Primitive.NO_HIT) {
                    continue;
                }
                Hit hit = primitive.hit(ray, distance);
                Vector3d away = aims.vector(1).normalize();
                double hitsItself =
                        primitive.distance(Ray.blank().setShadow(hit, away.x, away.y, away.z), Primitive.NO_HIT);
                if (away.dot(hit.normalX, hit.normalY, hit.normalZ) > 0) {
                    outwards++;
                    boolean misses = primitive.leavesConvexShape(hit, away.x, away.y, away.z);
                    assertThat(misses || primitive instanceof CapPrimitive)
                            .as(primitive.description())
                            .isTrue();
                    assertThat(misses && hitsItself < Primitive.NO_HIT)
                            .as(primitive.description())
                            .isFalse();
                } else if (hitsItself < Primitive.NO_HIT) {
                    inwards++;
                    assertThat(primitive.leavesConvexShape(hit, away.x, away.y, away.z))
                            .as(primitive.description())
                            .isFalse();
                }
            }
        }
        assertThat(outwards).isGreaterThan(3000);
        assertThat(inwards).isGreaterThan(1000);
    }

    @Test
    void planeTellsRaysThatGoAwayFromIt() {
        Plane plane = new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), ColouredSurface.DEFAULT);
        Primitive floor = PrimitiveCollector.primitivesOf(plane).get(0);
        Hit above = startOf(Ray.from(0, 2, 0, 1, 0, 0, 0));

        assertThat(floor.leavesConvexShape(above, 0.6, 0.8, 0)).isTrue();
        assertThat(floor.leavesConvexShape(above, 0.6, -0.8, 0)).isFalse();
    }

    static Hit startOf(Ray ray) {
        return Hit.blank().set(ray, 0, 0, 0, 1, null, 0, null);
    }

    private Ray aimed(Primitive primitive, Vector3dc start) {
        Vector3d target = aims.placeIn(primitive);
        if (primitive instanceof CylinderPrimitive rod && rod.longAxis() != null) {
            // most rays to the box of a rod miss it: here to its axis
            double along = aims.mix(-0.5, 0.5);
            target = rod.longAxis().mul(along).add(primitive.bounds().centre());
        }
        return EdgeRays.towards(start, target);
    }
}
