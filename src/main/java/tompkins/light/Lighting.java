package tompkins.light;

import tompkins.ray.Hit;

/** What gets from the sources of light to a hit. */
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
}
