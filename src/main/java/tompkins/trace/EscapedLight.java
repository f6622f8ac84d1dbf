package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/** The light of rays that escape: they leave the objects of their frame, and meet what is behind these. */
@FunctionalInterface
interface EscapedLight {

    /** The light that comes back. */
    Colour colour(Ray ray);

    /** The same for a ray of a packet. */
    default Colour colour(RayPacket rays, int place) {
        return colour(rays.ray(place));
    }

    /** The light that comes back, if it is the same for all rays; otherwise null. */
    default Colour evenLight() {
        return null;
    }

    /** The light that comes back, as the camera sees it; for surroundings that shift light where it leaves a hit. */
    default Colour seen(Ray ray, Surroundings surroundings) {
        return surroundings.seen(colour(ray), ray, 1);
    }
}
