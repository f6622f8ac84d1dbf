package tompkins.trace;

import tompkins.ray.Colour;
import tompkins.ray.Ray;

/** What becomes of a ray that leaves the objects of its frame. */
@FunctionalInterface
interface Beyond {

    /** The light that comes back. */
    Colour colour(Ray ray);
}
