package tompkins.light;

import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** What gets from the sources of light to a hit, and from there to the camera. */
public interface Lighting {

    /**
     * Finds the way from a hit to a point source.
     *
     * @param source number of the source
     * @param sight receives the way
     * @return false if no light of the source gets to that event
     */
    boolean find(int source, Hit hit, Sightline sight);

    /** Whether nothing throws a shadow on a hit along a way that was found for it. */
    boolean isClear(int source, Hit hit, Sightline sight);

    /** Whether {@link #seen} changes anything. */
    boolean shifts();

    /**
     * How light that leaves a hit looks to the camera, where {@link #shifts()}.
     *
     * @param light the light in the frame of the hit, as if source and surface had one frame
     * @param ray the ray that has hit there
     * @param dopplerFactor frequency in the frame of the hit divided by that in the frame of the source
     */
    Colour seen(Colour light, Ray ray, double dopplerFactor);
}
