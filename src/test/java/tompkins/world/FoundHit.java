package tompkins.world;

import org.joml.Vector3d;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.spacetime.Event;

/** A hit that was searched for in all frames. */
final class FoundHit {

    final Hit hit;
    final Ray ray;
    private final Event own;
    private final Event inScene;

    FoundHit(MovingRow row, Hit hit) {
        this.hit = hit;
        ray = hit.ray;
        Hit event = hit.event == null ? hit : hit.event;
        inScene = row.inScene(event.frame, new Event(event.x, event.y, event.z, event.time));
        own = ((Primitive) hit.boundary).restFrame().own(new Event(hit.x, hit.y, hit.z, hit.time));
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
