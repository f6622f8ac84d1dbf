package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.EdgeRays;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.Sphere;
import tompkins.surface.ColouredSurface;

/** What a lamp sees of primitives that it passes throws the shadows that the tree finds. */
class LampTrackTest {

    private static final int RAYS = 20_000;

    private final AtomicLong left = new AtomicLong(Long.MAX_VALUE);

    /** A lamp that goes across the view, one that goes along it from behind, and those that pass askew or far away. */
    @ParameterizedTest
    @CsvSource({
        " 200,  3,  5, -7,  1,    0,    0",
        "5000,  3,  5, -7,  0.3, -0.1, -0.5",
        "  12,  1, -1,  0,  0,    0,    1",
        "5000,  1, -1,  0,  0,    0,    1",
        "5000, -4,  5,  2,  0.2,  0.1,  0.6",
        "5000,  0, 40, 10,  0,    1,    1",
        "5000,  0,  2, 10,  1,    0.01, 0"
    })
    void shadowsAreThoseOfTheTree(
            int count, double x, double y, double z, double alongX, double alongY, double alongZ) {
        Random random = new Random(count);
        ObjectTree tree = new ObjectTree(LampShadowsTest.primitives(LampShadowsTest.mixed(count, random)));
        Vector3d from = new Vector3d(x, y, z);
        Vector3d along = new Vector3d(alongX, alongY, alongZ);
        LampTrack track = LampTrack.of(from, from.add(along, new Vector3d()), tree, left);
        RayCounts counts = new RayCounts();
        NearestHit scratch = new NearestHit(new RayCounts());
        int asked = 0;
        int shadows = 0;
        for (int i = 0; i < RAYS; i++) {
            Vector3d lamp = from.fma(random.nextDouble(-20, 20), along, new Vector3d());
            Ray ray = EdgeRays.towards(LampShadowsTest.place(random), lamp);
            double distance = lamp.distance(ray.x, ray.y, ray.z);
            double place = track.at(ray, distance);
            LampShadows seen = place == LampTrack.NOWHERE ? null : track.seenFrom(place);
            if (seen == null) {
                continue;
            }
            asked++;
            boolean dark = tree.shadow(ray, distance, scratch) != null;

            assertThat(seen.shadows(QuickRejectionTest.startOf(ray), ray, place - Math.floor(place), distance, counts))
                    .isEqualTo(dark);
            shadows += dark ? 1 : 0;
        }
        assertThat(asked).isGreaterThan(RAYS / 10);
        assertThat(shadows).isBetween(asked / 20, asked * 19 / 20);
        assertThat(counts.tests).isLessThan(6L * asked);
    }

    /** The track of a lamp through the origin past a row of balls around a place. */
    private LampTrack track(int balls, double x, double z, Vector3d along) {
        List<Primitive> row = new ArrayList<>();
        for (int i = 0; i < balls; i++) {
            Vector3d place = new Vector3d(x, (2.0 * i + 1 - balls) / balls, z);
            row.addAll(PrimitiveCollector.primitivesOf(new Sphere("ball", place, 0.1, ColouredSurface.DEFAULT)));
        }
        return LampTrack.of(new Vector3d(), along, new ObjectTree(row), left);
    }

    /** Few or very many primitives, a lamp that rests, and coordinates whose rounding is seen. */
    @ParameterizedTest
    @CsvSource({
        "10, 0, 8, 1, true",
        "9, 0, 8, 1, false",
        "20001, 0, 8, 1, false",
        "10, 0, 8, 0, false",
        "10, 5e4, 0, 1, true",
        "10, 1e5, 0, 1, false"
    })
    void trackIsMadeWhereItIsWorthWhile(int balls, double x, double z, double way, boolean isMade) {
        assertThat(track(balls, x, z, new Vector3d(way, 0, 0)) != null).isEqualTo(isMade);
    }

    /** With the row at a distance of 8, a piece has the length 1, and 64 of them lie around the nearest place. */
    @ParameterizedTest
    @CsvSource({
        "-31.9, 0, 0, 0.1",
        "31.9, 0, 0, 63.9",
        "-32.1, 0, 0, -1",
        "32.1, 0, 0, -1",
        "0, 1e-10, 0, 32",
        "0, 1e-8, 0, -1",
        "0, 0, 9e5, 32",
        "0, 0, 2e6, -1"
    })
    void placesOnTheTrackAreTold(double x, double y, double behind, double expected) {
        Ray ray = EdgeRays.towards(new Vector3d(x, y, 8 + behind), new Vector3d(x, y, 0));

        assertThat(track(10, 0, 8, new Vector3d(1, 0, 0)).at(ray, 8 + behind)).isCloseTo(expected, within(1e-9));
    }
}
