package tompkins.world;

import java.util.Arrays;
import org.joml.Vector3dc;
import tompkins.light.LightSource;
import tompkins.light.Sightline;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.search.LampShadows;
import tompkins.search.LampTrack;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.spacetime.TransformationLaw;

/**
 * The ways of light from lamps to a hit, when both may move: a lamp shines from where it was when the light left it,
 * and what was in the way when the light passed throws the shadow. One for each thread.
 */
public final class LampWays {

    private final World world;
    private final FrameRoutes routes;
    private final boolean galilean;
    private final RayCounts counts;
    private final NearestHit scratch;
    private final int[] lampFrames;
    private final ObjectTree[] trees;
    private final int[] filled;
    private final Primitive[] lastShadows;
    private final Hit place = Hit.blank();
    private final Ray eventRay = Ray.blank();
    private final Ray way = Ray.blank();
    private final Ray shadow = Ray.blank();
    private final Ray inFrame = Ray.blank();

    /** The ways in a world, for one thread. */
    public LampWays(World world, FrameRoutes routes, TransformationLaw law, RayCounts counts) {
        this.world = world;
        this.routes = routes;
        galilean = law == TransformationLaw.GALILEAN;
        this.counts = counts;
        scratch = new NearestHit(counts);
        trees = world.trees();
        filled = world.filledFrames();
        lampFrames = new int[world.lights().size()];
        for (int i = 0; i < lampFrames.length; i++) {
            lampFrames[i] = world.frameOfLight(i);
        }
        lastShadows = new Primitive[world.frameCount()];
    }

    /** Forgets what was seen before, so that the work for a packet depends on nothing else. */
    public void beginBlock() {
        Arrays.fill(lastShadows, null);
    }

    /**
     * Finds the way from a hit to a lamp.
     *
     * @param frame the frame of the hit
     * @param event the event of the hit in the frame in which the ray came, where the speed of the object causes less
     *     rounding
     * @param eventFrame that frame
     * @return false if no light of the lamp gets to the event
     */
    public boolean find(int source, int frame, Hit hit, int eventFrame, Hit event, Sightline sight) {
        LightSource lamp = world.lights().get(source);
        int lampFrame = lampFrames[source];
        Vector3dc at = lamp.position();
        if (galilean) {
            return findWithOneCarrier(at, lampFrame, frame, hit, sight);
        }
        if (lampFrame == frame) {
            sight.set(at.x() - hit.x, at.y() - hit.y, at.z() - hit.z);
            return true;
        }
        routes.transform(eventFrame, lampFrame, way.setShadow(event, 0, 0, 1), way);
        double x = at.x() - way.x;
        double y = at.y() - way.y;
        double z = at.z() - way.z;
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length == 0) {
            return false;
        }
        routes.transform(lampFrame, frame, way.aim(x / length, y / length, z / length), way);
        double stretched = length * way.stretch;
        sight.set(way.dx * stretched, way.dy * stretched, way.dz * stretched, way.stretch, 1);
        return true;
    }

    /**
     * In a Galilean world light has speed 1 in the camera frame, on every leg. With R from the hit to where the lamp is
     * at the time of the hit, and its velocity w, both in the camera frame, the light has been on its way for the time
     * s that solves |R - w s| = s.
     */
    private boolean findWithOneCarrier(Vector3dc at, int lampFrame, int frame, Hit hit, Sightline sight) {
        routes.toCamera(frame, eventRay.setShadow(hit, 0, 0, 1), eventRay);
        double hitX = eventRay.x;
        double hitY = eventRay.y;
        double hitZ = eventRay.z;
        double hitTime = eventRay.time;
        place.setPlace(at.x(), at.y(), at.z(), 0);
        routes.toCamera(lampFrame, eventRay.setShadow(place, 0, 0, 1), eventRay);
        double lampX = eventRay.x;
        double lampY = eventRay.y;
        double lampZ = eventRay.z;
        double later = hitTime - eventRay.time;
        place.setPlace(at.x(), at.y(), at.z(), 1);
        routes.toCamera(lampFrame, eventRay.setShadow(place, 0, 0, 1), eventRay);
        double wx = eventRay.x - lampX;
        double wy = eventRay.y - lampY;
        double wz = eventRay.z - lampZ;
        double rx = lampX + wx * later - hitX;
        double ry = lampY + wy * later - hitY;
        double rz = lampZ + wz * later - hitZ;
        double along = rx * wx + ry * wy + rz * wz;
        double squared = rx * rx + ry * ry + rz * rz;
        double root = along * along + (1 - wx * wx - wy * wy - wz * wz) * squared;
        double divisor = along + Math.sqrt(root);
        double duration = divisor > 0 ? squared / divisor : 0;
        if (!(duration > 0)) {
            return false;
        }
        place.setPlace(hitX, hitY, hitZ, hitTime);
        way.setShadow(place, rx / duration - wx, ry / duration - wy, rz / duration - wz);
        routes.fromCamera(frame, way, way);
        double stretched = duration * way.stretch;
        sight.set(way.dx * stretched, way.dy * stretched, way.dz * stretched, 1, way.slowness);
        return true;
    }

    /**
     * Whether nothing throws a shadow on a hit along a way that was found for it; the parameters are those of
     * {@link #find}.
     */
    public boolean isClear(int source, int frame, Hit hit, int eventFrame, Hit event, Sightline sight) {
        counts.shadowRays++;
        double length = Math.sqrt(sight.x * sight.x + sight.y * sight.y + sight.z * sight.z);
        shadow.setShadow(hit, sight.x / length, sight.y / length, sight.z / length, sight.slowness);
        for (int i : filled) {
            if (i == frame) {
                if (isDark(source, i, hit, shadow, length)) {
                    return false;
                }
                continue;
            }
            routes.transform(frame, i, shadow, inFrame);
            if (Double.isNaN(inFrame.dx)) {
                continue;
            }
            Ray start = routes.transform(eventFrame, i, eventRay.setShadow(event, 0, 0, 1), eventRay);
            place.setPlace(start.x, start.y, start.z, start.time);
            inFrame.setStart(place);
            if (isDark(source, i, place, inFrame, length * inFrame.stretch)) {
                return false;
            }
        }
        return true;
    }

    private boolean isDark(int source, int frame, Hit start, Ray ray, double length) {
        LampShadows seen = null;
        double place = 0;
        LampTrack track = world.lampTrack(source, frame);
        if (lampFrames[source] == frame) {
            seen = world.lampShadows(source);
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
        scratch.forgetLeaf();
        lastShadows[frame] = trees[frame].shadow(ray, length, scratch);
        return lastShadows[frame] != null;
    }
}
