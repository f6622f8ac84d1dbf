package tompkins.trace;

import java.util.List;
import org.joml.Vector3dc;
import tompkins.light.LightSource;
import tompkins.light.Sightline;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.search.LampShadows;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;

/** The ways to the lamps of a frame in which nothing moves, and what is in the way. One for each thread. */
final class RestingLamps {

    private final ObjectTree objects;
    private final List<LightSource> lights;
    private final LampShadows[] lampShadows;
    private final RayCounts counts;
    private final NearestHit scratch;
    private final Ray memory = Ray.blank();

    /** What threw the last shadow: it often throws the next one, too. */
    private Primitive lastShadow;

    /**
     * The lamps of a frame.
     *
     * @param objects what may be in the way
     * @param lampShadows what each of the lights sees of the objects, or null for those of which that is not prepared
     * @param scratch memory for searches; its result is not touched
     */
    RestingLamps(
            ObjectTree objects,
            List<LightSource> lights,
            LampShadows[] lampShadows,
            RayCounts counts,
            NearestHit scratch) {
        this.objects = objects;
        this.lights = lights;
        this.lampShadows = lampShadows;
        this.counts = counts;
        this.scratch = scratch;
    }

    /** Forgets what threw the last shadow. */
    void forget() {
        lastShadow = null;
    }

    /** Sets the way from a hit to a point source. */
    void find(int source, Hit hit, Sightline sight) {
        Vector3dc lamp = lights.get(source).position();
        sight.set(lamp.x() - hit.x, lamp.y() - hit.y, lamp.z() - hit.z);
    }

    /** Whether nothing throws a shadow on a hit along a way that was found for it. */
    boolean isClear(int source, Hit from, Sightline sight) {
        counts.shadowRays++;
        double distance = Math.sqrt(sight.x * sight.x + sight.y * sight.y + sight.z * sight.z);
        double toX = sight.x / distance;
        double toY = sight.y / distance;
        double toZ = sight.z / distance;
        LampShadows seen = lampShadows[source];
        if (seen != null) {
            return !seen.shadows(from, toX, toY, toZ, distance, memory, counts);
        }
        Ray ray = memory.setShadow(from, toX, toY, toZ);
        if (lastShadow != null && lastShadow.shadows(ray, distance)) {
            return false;
        }
        lastShadow = objects.shadow(ray, distance, scratch);
        return lastShadow == null;
    }
}
