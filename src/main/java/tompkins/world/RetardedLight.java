package tompkins.world;

import java.util.Arrays;
import java.util.List;
import org.joml.Vector3dc;
import tompkins.light.Lighting;
import tompkins.light.Sightline;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.search.ContactSearch;
import tompkins.search.LampShadows;
import tompkins.search.LampTrack;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.spacetime.TransformationLaw;

/**
 * The ways of light from lamps to a hit, when both may move: a lamp shines from where it was when the light left it,
 * and what was in the way when the light passed throws the shadow. One for each thread.
 */
final class RetardedLight implements Lighting {

    private final FrameRoutes routes;
    private final RayCounts counts;
    private final NearestHit scratch;
    private final Lamp[] lamps;

    /** The velocities of the lamps in the camera frame; null unless light has one carrier. */
    private final Vector3dc[] lampVelocities;

    private final ObjectTree[] trees;

    /** The numbers of the frames in which something may throw shadows. */
    private final int[] darkening;

    private final Primitive[] lastShadows;
    private final Hit place = Hit.blank();
    private final Ray eventRay = Ray.blank();
    private final Ray way = Ray.blank();
    private final Ray shadow = Ray.blank();
    private final Ray fromEvent = Ray.blank();
    private final Ray inFrame = Ray.blank();

    /** The ways of light to hits among the objects of some frames, null where nothing is searched; for one thread. */
    RetardedLight(ObjectTree[] trees, List<Lamp> lamps, FrameRoutes routes, TransformationLaw law, RayCounts counts) {
        this.trees = trees;
        this.routes = routes;
        this.counts = counts;
        scratch = new NearestHit(counts);
        int[] filled = Surroundings.filled(trees);
        darkening = filled.length == 1
                ? filled
                : Arrays.stream(filled)
                        .filter(frame -> trees[frame].throwsShadows())
                        .toArray();
        this.lamps = lamps.toArray(Lamp[]::new);
        lampVelocities = law != TransformationLaw.GALILEAN
                ? null
                : lamps.stream()
                        .map(lamp -> routes.route(lamp.frame(), routes.camera())
                                .worldLine()
                                .position())
                        .toArray(Vector3dc[]::new);
        lastShadows = new Primitive[trees.length];
    }

    /** Forgets what was seen before, so that the work for a packet depends on nothing else. */
    void beginBlock() {
        Arrays.fill(lastShadows, null);
    }

    @Override
    public boolean find(int source, Hit hit, Sightline sight) {
        Lamp lamp = lamps[source];
        if (lampVelocities != null) {
            return findWithOneCarrier(lamp, lampVelocities[source], hit, sight);
        }
        if (lamp.frame() == hit.frame) {
            lamp.find(hit, sight);
            return true;
        }
        Vector3dc at = lamp.position();
        routes.transform(way.setShadow(hit.event, 0, 0, 1), lamp.frame(), way);
        double x = at.x() - way.x;
        double y = at.y() - way.y;
        double z = at.z() - way.z;
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length == 0) {
            return false;
        }
        double emission = way.time - length - lamp.properTimeZero();
        routes.transform(way.aim(x / length, y / length, z / length), hit.frame, way);
        double stretched = length * way.directionLength;
        sight.set(way.dx * stretched, way.dy * stretched, way.dz * stretched, way.directionLength, 1, emission);
        return true;
    }

    /**
     * In a Galilean world light has speed 1 in the camera frame, on every leg. With R from the hit to where the lamp is
     * at the time of the hit, and its velocity w, both in the camera frame, the light has been on its way for the time
     * s that solves |R - w s| = s.
     */
    private boolean findWithOneCarrier(Lamp lamp, Vector3dc w, Hit hit, Sightline sight) {
        Vector3dc at = lamp.position();
        routes.transform(eventRay.setShadow(hit, 0, 0, 1), routes.camera(), eventRay);
        double hitX = eventRay.x;
        double hitY = eventRay.y;
        double hitZ = eventRay.z;
        double hitTime = eventRay.time;
        place.setPlace(lamp.frame(), at.x(), at.y(), at.z(), 0);
        routes.transform(eventRay.setShadow(place, 0, 0, 1), routes.camera(), eventRay);
        double later = hitTime - eventRay.time;
        double rx = eventRay.x + w.x() * later - hitX;
        double ry = eventRay.y + w.y() * later - hitY;
        double rz = eventRay.z + w.z() * later - hitZ;
        double along = rx * w.x() + ry * w.y() + rz * w.z();
        double squared = rx * rx + ry * ry + rz * rz;
        double root = along * along + (1 - w.x() * w.x() - w.y() * w.y() - w.z() * w.z()) * squared;
        double divisor = along + Math.sqrt(root);
        double duration = divisor > 0 ? squared / divisor : 0;
        if (!(duration > 0)) {
            return false;
        }
        place.setPlace(routes.camera(), hitX, hitY, hitZ, hitTime);
        way.setShadow(place, rx / duration - w.x(), ry / duration - w.y(), rz / duration - w.z());
        routes.transform(way, hit.frame, way);
        double stretched = duration * way.directionLength;
        sight.set(
                way.dx * stretched,
                way.dy * stretched,
                way.dz * stretched,
                1,
                way.slowness,
                later - duration - lamp.properTimeZero());
        return true;
    }

    @Override
    public boolean isClear(int source, Hit hit, Sightline sight) {
        counts.shadowRays++;
        double length = sight.length;
        shadow.setShadow(hit, sight.x / length, sight.y / length, sight.z / length, sight.slowness);
        Ray turned = null;
        for (int i : darkening) {
            if (i == hit.frame) {
                if (isDark(lamps[source], i, hit, shadow, length)) {
                    return false;
                }
                continue;
            }
            Ray start;
            // most ways lead through the frame in which the ray began, where its event is known best
            if (routes.passesThrough(hit.frame, hit.event.frame, i)) {
                if (turned == null) {
                    turned = routes.transform(shadow, hit.event.frame, fromEvent);
                    turned.setStart(hit.event);
                }
                start = routes.transform(turned, i, inFrame);
            } else {
                routes.transform(shadow, i, inFrame);
                start = routes.transform(eventRay.setShadow(hit.event, 0, 0, 1), i, eventRay);
            }
            place.setPlace(i, start.x, start.y, start.z, start.time);
            inFrame.setStart(place);
            boolean hasDirection = !Double.isNaN(inFrame.dx);
            if (hasDirection && isDark(lamps[source], i, place, inFrame, length * inFrame.directionLength)) {
                return false;
            }
        }
        return true;
    }

    private boolean isDark(Lamp lamp, int frame, Hit start, Ray ray, double length) {
        if (ContactSearch.isInShadow(ray)) {
            return true;
        }
        LampShadows seen = null;
        double place = 0;
        LampTrack track = lamp.track(frame);
        if (lamp.frame() == frame) {
            seen = lamp.shadows();
        } else if (track != null) {
            place = track.at(ray, length);
            seen = place == LampTrack.NOWHERE ? null : track.seenFrom(place);
        }
        if (seen != null) {
            return seen.shadows(start, ray, place - Math.floor(place), length, counts);
        }
        Primitive last = lastShadows[frame];
        if (last != null && last.shadows(ray, length)) {
            return true;
        }
        lastShadows[frame] = trees[frame].shadow(ray, length, scratch);
        return lastShadows[frame] != null;
    }
}
