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
    final int frame;
    private final MovingRow row;
    private final Event own;

    FoundHit(MovingRow row, WorldSearch search, NearestHit nearest) {
        this.row = row;
        ray = search.ray();
        frame = search.frame();
        hit = nearest.hit(ray, Hit.blank());
        own = nearest.primitive().restFrame().own(traced());
    }

    private Event traced() {
        return new Event(hit.x, hit.y, hit.z, hit.time);
    }

    /** Distance in units of the direction with which the ray has left the camera. */
    double lambda() {
        return hit.distance / ray.stretch;
    }

    /** The event in the frame in which the object is described. */
    Event own() {
        return own;
    }

    Event inScene() {
        return row.inScene(frame, traced());
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
