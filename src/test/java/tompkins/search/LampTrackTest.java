package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.EdgeRays;

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
}
