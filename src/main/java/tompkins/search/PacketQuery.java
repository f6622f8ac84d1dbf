package tompkins.search;

import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/**
 * The search for what the rays of a packet meet among the objects of one frame: for all together as far as that helps,
 * else for a few neighbours from where they enter the tree, else for each from its root. The result is the same as that
 * of a search of its own. One for each thread, used again for every packet.
 */
public final class PacketQuery {

    private final ObjectTree objects;
    private final NearestHit nearest;
    private final PacketSearch search = new PacketSearch();
    private final EntryNodes entries = new EntryNodes();
    private final Ray ray = Ray.blank();
    private RayPacket rays;

    /** Where each ray must search; null if what they meet was found for all together. */
    private TreeParts parts;

    private boolean hasEntries;

    /** A search among objects, whose results the memory holds. */
    public PacketQuery(ObjectTree objects, NearestHit nearest) {
        this.objects = objects;
        this.nearest = nearest;
    }

    /** Begins to search for the rays of a packet, which must stay as they are. */
    public void begin(RayPacket newRays) {
        rays = newRays;
        parts = search.find(objects, rays, nearest);
        hasEntries = false;
    }

    /** Whether some ray may meet something. */
    public boolean mayMeet() {
        return parts != null || search.mayMeet();
    }

    /** Whether the ray at a place may meet something. */
    public boolean mayMeet(int place) {
        return parts != null || search.mayMeet(place);
    }

    /**
     * Searches for the nearest hit of a ray; asked in the order of the places.
     *
     * @param limit what is farther may be left out
     * @return whether there is one; the memory holds it, and {@link #ray()} the ray
     */
    public boolean nearest(int place, double limit) {
        if (parts == null) {
            return search.mayMeet(place) && search.nearest(rays.copy(place, ray), place, limit, nearest);
        }
        if (place % EntryNodes.RAYS == 0) {
            hasEntries = entries.find(objects, parts, rays, place, Math.min(rays.count(), place + EntryNodes.RAYS));
        }
        rays.copy(place, ray);
        return hasEntries ? objects.nearest(ray, limit, entries, nearest) : objects.nearest(ray, limit, nearest);
    }

    /** The ray whose hit was found last. */
    public Ray ray() {
        return ray;
    }
}
