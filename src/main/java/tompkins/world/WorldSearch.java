package tompkins.world;

import tompkins.primitive.Primitive;
import tompkins.ray.Contact;
import tompkins.ray.Hit;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.search.ContactSearch;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.search.PacketSearch;

/**
 * The search for the nearest hit in several frames. A ray is taken into each of them; its distances there are given in
 * units of the direction that it had at the camera, which are the same in all frames. One for each thread.
 */
public final class WorldSearch extends Padded {

    private final ObjectTree[] trees;
    private final int[] filled;
    private final FrameRoutes routes;
    private final NearestHit nearest;
    private final Ray[] mapped;
    private final FramePacket[] packets;

    /** The packets with rays that may meet something. */
    private final FramePacket[] open;

    private int openCount;
    private final Ray packetStart = Ray.blank();
    private RayPacket startRays;

    // of the search that was made last
    private Primitive found;
    private double distance;
    private double share;
    private double reach;
    private boolean shared;
    private Ray ray;
    private Ray start;

    /** The surfaces where it ends; null if there is only one. */
    private Contact contact;

    /** A search with the memory of its thread. */
    public WorldSearch(World world, FrameRoutes routes, NearestHit nearest) {
        trees = world.trees();
        filled = world.filledFrames();
        this.routes = routes;
        this.nearest = nearest;
        int count = trees.length;
        mapped = new Ray[count];
        packets = new FramePacket[count];
        open = new FramePacket[count];
        for (int i = 0; i < count; i++) {
            mapped[i] = Ray.blank();
        }
    }

    /** The rays of a packet in one frame, and what they meet there. */
    private static final class FramePacket {
        final RayPacket rays = new RayPacket(RayPacket.MOST);
        final PacketSearch query;

        FramePacket(ObjectTree objects, NearestHit nearest) {
            query = new PacketSearch(objects, nearest);
        }
    }

    /**
     * Searches for the nearest primitive that a ray hits, in all frames.
     *
     * @return whether there is one; it is in the memory of the thread, and {@link #ray()} the ray
     */
    public boolean nearest(Ray newStart) {
        begin(newStart);
        contact = start.contact == null ? null : start.contact.next();
        if (contact != null) {
            ray = inFrame(contact.hits().get(0).frame);
            return true;
        }
        int from = start.frame;
        // nothing rests in the frame of the camera
        if (from < trees.length) {
            trees[from].nearest(start, Primitive.NO_HIT, nearest);
            compare(start);
        }
        for (int i : filled) {
            if (i == from) {
                continue;
            }
            Ray inFrame = routes.transform(start, i, mapped[i]);
            if (!Double.isNaN(inFrame.dx)) {
                trees[i].nearest(inFrame, limit(inFrame.directionLength), nearest);
                compare(inFrame);
            }
        }
        if (ray != start) {
            // the ray must stay as it is while others are searched for
            mapped[ray.frame] = Ray.blank();
        }
        return end();
    }

    /** Begins to search for the rays of a packet. */
    public void begin(RayPacket rays) {
        startRays = rays;
        openCount = 0;
        for (int i : filled) {
            if (packets[i] == null) {
                packets[i] = new FramePacket(trees[i], nearest);
            }
            FramePacket packet = packets[i];
            packet.rays.set(rays);
            routes.transform(packet.rays, i);
            packet.query.begin(packet.rays);
            if (packet.query.mayMeet()) {
                open[openCount++] = packet;
            }
        }
    }

    /** Whether a ray of that packet may meet something. */
    public boolean mayMeet(int place) {
        for (int i = 0; i < openCount; i++) {
            if (open[i].query.mayMeet(place)) {
                return true;
            }
        }
        return false;
    }

    /** As {@link #nearest(Ray)}, for a ray of that packet; asked in the order of the places. */
    public boolean nearest(int place) {
        begin(packetStart);
        for (int i = 0; i < openCount; i++) {
            RayPacket rays = open[i].rays;
            PacketSearch query = open[i].query;
            if (query.mayMeet(place)
                    && !Double.isNaN(rays.dx[place])
                    && query.nearest(place, limit(rays.directionLength[place]))) {
                compare(query.ray());
            }
        }
        if (found != null) {
            startRays.copy(place, packetStart);
        }
        return end();
    }

    private void begin(Ray newStart) {
        start = newStart;
        ray = newStart;
        found = null;
        distance = Primitive.NO_HIT;
        share = Primitive.NO_HIT;
        reach = Primitive.NO_HIT;
        shared = false;
        contact = null;
    }

    private double limit(double directionLength) {
        return found == null ? Primitive.NO_HIT : reach * directionLength;
    }

    /** The start in a frame, in memory of its own. */
    private Ray inFrame(int frame) {
        return frame == start.frame ? start : routes.transform(start, frame, Ray.blank());
    }

    /**
     * Takes what was found last if it is nearer than everything before; of equally near primitives it takes the one
     * listed first.
     */
    private void compare(Ray inFrame) {
        Primitive candidate = nearest.primitive();
        if (candidate == null) {
            return;
        }
        double candidateShare = nearest.distance() / inFrame.directionLength;
        if (candidateShare > share || candidateShare == share && found != null && candidate.order() > found.order()) {
            shared |= candidateShare <= reach;
        } else {
            reach = nearest.reach() / inFrame.directionLength;
            shared = nearest.isShared() || found != null && share <= reach;
            found = candidate;
            distance = nearest.distance();
            share = candidateShare;
            ray = inFrame;
        }
    }

    private boolean end() {
        nearest.resume(found, distance, distance, false);
        return found != null && (!shared || meets());
    }

    /** Whether the ray meets something where surfaces touch: together they may do nothing. */
    private boolean meets() {
        ContactSearch search = new ContactSearch();
        for (int i : filled) {
            Ray inFrame = inFrame(i);
            if (!Double.isNaN(inFrame.dx)) {
                search.add(trees[i], inFrame, reach * inFrame.directionLength);
            }
        }
        Contact all = search.contact();
        contact = all == null ? null : all.next();
        if (contact != null) {
            ray = inFrame(contact.hits().get(0).frame);
        }
        return all == null || contact != null || nearest(ray.past(hit(Hit.blank()), all));
    }

    /** The ray of the hit that was found last, in the frame of what it has hit. */
    public Ray ray() {
        return ray;
    }

    /** That hit, in memory that may be used again. */
    public Hit hit(Hit memory) {
        boolean isAlone = contact == null;
        Hit hit = isAlone ? nearest.hit(ray, memory) : contact.hit();
        double length = (isAlone ? share : hit.distance / ray.directionLength) * start.directionLength;
        hit.eventMemory()
                .setPlace(
                        start.frame,
                        start.x + length * start.dx,
                        start.y + length * start.dy,
                        start.z + length * start.dz,
                        start.timeAt(length));
        return hit;
    }
}
