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
    default Colour colour(RayPacket rays, int index) {
        return colour(rays.ray(index));
    }

    /** The light that comes back along each ray, if it is the same for all; otherwise null. */
    default Colour evenLight() {
        return null;
    }
}
