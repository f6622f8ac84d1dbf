package tompkins.world;

import org.joml.Vector3d;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.search.NearestHit;
import tompkins.spacetime.Event;

/** A hit that was searched for in all frames. */
final class FoundHit {

    final Hit hit;
    final Ray ray;
    private final Event own;
    private final Event inScene;

    FoundHit(MovingRow row, WorldSearch search, NearestHit nearest) {
        ray = search.ray();
        hit = search.hit(Hit.blank());
        inScene = row.inScene(hit.event.frame, new Event(hit.event.x, hit.event.y, hit.event.z, hit.event.time));
        own = nearest.primitive().restFrame().own(traced());
    }

    private Event traced() {
        return new Event(hit.x, hit.y, hit.z, hit.time);
    }

    /** Distance in units of the direction with which the ray has left the camera. */
    double lambda() {
        return hit.distance / ray.directionLength;
    }

    /** The event in the frame in which the object is described. */
    Event own() {
        return own;
    }

    Event inScene() {
        return inScene;
    }

    Vector3d normal() {
        return new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
    }

    Vector3d ownDirection() {
        return new Vector3d(ray.dx, ray.dy, ray.dz);
    }

    /** Frequency at the camera divided by that in the frame of the object. */
    double dopplerFactor() {
        return 1 / ray.frequency;
    }
}
