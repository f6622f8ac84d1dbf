package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/** What becomes of a ray that leaves the objects of its frame. */
@FunctionalInterface
interface Beyond {

    /** The light that comes back. */
    Colour colour(Ray ray);

    /** The same for a ray of a packet. */
    default Colour colour(RayPacket rays, int place) {
        return colour(rays.ray(place));
    }
}
