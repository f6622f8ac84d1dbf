package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.fuzz.RandomStudio;
import tompkins.primitive.CapPrimitive;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Primitive;
import tompkins.primitive.RayStarts;
import tompkins.property.Descriptions;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.surface.ColouredSurface;

/** What tells rays from a primitive without testing them never tells one that hits, and tells most that miss. */
class QuickRejectionTest {

    private static final int RAYS = 200;
    private static final double RADIUS = 0.02;

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

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void noRayThatHitsHasAnOverlapBelowZero(boolean oneStart) {
        int hits = 0;
        for (Primitive primitive : primitives().toList()) {
            hits += hitsThatKeepTheirOverlap(primitive, 30, oneStart);
        }
        assertThat(hits).isGreaterThan(5000);
    }

    /** Rounding grows with the distance of the start; the overlap knows. */
    @ParameterizedTest
    @MethodSource("thinOnes")
    void rayThatStartsFarAwayAndHitsHasNoOverlapBelowZero(Primitive primitive) {
        for (double distance : new double[] {1e2, 1e4, 1e6, 1e8}) {
            assertThat(hitsThatKeepTheirOverlap(primitive, distance, false)).isPositive();
            assertThat(hitsThatKeepTheirOverlap(primitive, distance, true)).isPositive();
        }
    }

    static Stream<Primitive> thinOnes() {
        return Stream.of(
                        new Cylinder(
                                "rod",
                                new Vector3d(-3, 1, 2),
                                new Vector3d(4, 2, 3),
                                RADIUS,
                                false,
                                ColouredSurface.DEFAULT),
                        new Sphere("ball", new Vector3d(1, 2, 3), RADIUS, ColouredSurface.DEFAULT))
                .map(object -> PrimitiveCollector.primitivesOf(object).get(0));
    }

    private int hitsThatKeepTheirOverlap(Primitive primitive, double reach, boolean oneStart) {
        RayPacket rays = new RayPacket(RAYS);
        rays.begin(RAYS);
        Vector3d start = aims.vector(reach);
        for (int i = 0; i < RAYS; i++) {
            rays.set(i, aimed(primitive, oneStart ? start : aims.vector(reach)));
        }
        RayStarts starts = new RayStarts();
        starts.measure(rays, 0, RAYS);
        assertThat(starts.areOne()).isEqualTo(oneStart);
        double[] overlaps = new double[RAYS];
        if (!primitive.overlaps(rays, starts, overlaps)) {
            return 0;
        }
        int hits = 0;
        for (int i = 0; i < RAYS; i++) {
            if (primitive.distance(rays.ray(i), Primitive.NO_HIT) < Primitive.NO_HIT) {
                hits++;
                assertThat(overlaps[i])
                        .as("%s, ray %d", primitive.description(), i)
                        .isGreaterThanOrEqualTo(0);
            }
        }
        return hits;
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

    private static Hit startOf(Ray ray) {
        return Hit.blank().set(ray, 0, 0, 0, 1, null, 0, null);
    }

    private Ray aimed(Primitive primitive, Vector3dc start) {
        Vector3d target = aims.placeIn(primitive);
        if (primitive instanceof CylinderPrimitive rod && rod.longAxis() != null) {
            // most rays to the box of a rod miss it: here to its axis
            double along = aims.mix(-0.5, 0.5);
            target = rod.longAxis().mul(along).add(primitive.bounds().centre());
        }
        return ray(start, target.sub(start, new Vector3d()));
    }

    private static Ray ray(Vector3dc start, Vector3dc towards) {
        Vector3d d = towards.normalize(new Vector3d());
        return Ray.from(start.x(), start.y(), start.z(), d.x, d.y, d.z, 0);
    }
}
