package tompkins.world;

import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.search.EntryNodes;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.search.PacketSearch;
import tompkins.search.TreeParts;

/**
 * The search for the nearest hit in several frames. A ray is taken into each of them; its distances there are given in
 * units of the direction that it had at the camera, which are the same in all frames. One for each thread.
 */
public final class WorldSearch {

    private final ObjectTree[] trees;
    private final int[] filled;
    private final FrameRoutes routes;
    private final NearestHit nearest;
    private final Ray[] mapped;
    private final FramePacket[] packets;
    private final Ray packetStart = Ray.blank();
    private RayPacket sceneRays;

    // of the search that was made last
    private Primitive found;
    private double distance;
    private double share;
    private int frame;
    private Ray ray;
    private Ray start;
    private int from;

    /** A search with the memory of its thread. */
    public WorldSearch(World world, FrameRoutes routes, NearestHit nearest) {
        trees = world.trees();
        filled = world.filledFrames();
        this.routes = routes;
        this.nearest = nearest;
        int count = trees.length;
        mapped = new Ray[count];
        packets = new FramePacket[count];
        for (int i = 0; i < count; i++) {
            mapped[i] = Ray.blank();
        }
    }

    /** The rays of a packet in one frame, and what was found for all of them together. */
    private static final class FramePacket {
        final RayPacket rays = new RayPacket(RayPacket.MOST);
        final PacketSearch search = new PacketSearch();
        final EntryNodes entries = new EntryNodes();

        /** The ray that is searched for now. */
        final Ray ray = Ray.blank();

        /** Where each ray must search; null if what they meet was found for all together. */
        TreeParts parts;

        boolean hasEntries;
    }

    /**
     * Searches for the nearest primitive that a ray hits, in all frames.
     *
     * @param from the frame of the ray
     * @return whether there is one; it is in the memory of the thread, {@link #ray()} and {@link #frame()}
     */
    public boolean nearest(Ray start, int from) {
        begin(start, from);
        trees[from].nearest(start, Primitive.NO_HIT, nearest);
        compare(start, from);
        for (int i : filled) {
            if (i == from) {
                continue;
            }
            Ray inFrame = routes.transform(from, i, start, mapped[i]);
            if (!Double.isNaN(inFrame.dx)) {
                trees[i].nearest(inFrame, limit(inFrame), nearest);
                compare(inFrame, i);
            }
        }
        ray = frame == from ? start : mapped[frame];
        if (found != null && frame != from) {
            // the ray must stay as it is while others are searched for
            mapped[frame] = Ray.blank();
        }
        return end();
    }

    /** Begins to search for the rays of a packet, which are in the scene frame. */
    public void begin(RayPacket rays) {
        sceneRays = rays;
        for (int i : filled) {
            if (packets[i] == null) {
                packets[i] = new FramePacket();
            }
            FramePacket packet = packets[i];
            packet.rays.set(rays);
            routes.transform(0, i, packet.rays);
            packet.parts = packet.search.find(trees[i], packet.rays, nearest);
            packet.hasEntries = false;
        }
    }

    /** As {@link #nearest(Ray, int)}, for a ray of that packet; asked in the order of the places. */
    public boolean nearest(int place) {
        begin(packetStart, 0);
        for (int i : filled) {
            search(packets[i], i, place);
        }
        if (found != null) {
            sceneRays.copy(place, packetStart);
            ray = packets[frame].ray;
        }
        return end();
    }

    private void search(FramePacket packet, int index, int place) {
        boolean isFound = packet.parts == null;
        if (!isFound && place % EntryNodes.RAYS == 0) {
            packet.hasEntries = packet.entries.find(
                    trees[index],
                    packet.parts,
                    packet.rays,
                    place,
                    Math.min(packet.rays.count(), place + EntryNodes.RAYS));
        }
        if (isFound && !packet.search.mayMeet(place) || Double.isNaN(packet.rays.dx[place])) {
            return;
        }
        Ray inFrame = packet.rays.copy(place, packet.ray);
        double limit = limit(inFrame);
        if (isFound) {
            packet.search.nearest(inFrame, place, limit, nearest);
        } else if (packet.hasEntries) {
            trees[index].nearest(inFrame, limit, packet.entries, nearest);
        } else {
            trees[index].nearest(inFrame, limit, nearest);
        }
        compare(inFrame, index);
    }

    private void begin(Ray newStart, int newFrom) {
        start = newStart;
        from = newFrom;
        found = null;
        distance = Primitive.NO_HIT;
        share = Primitive.NO_HIT;
        frame = newFrom;
    }

    private double limit(Ray inFrame) {
        return found == null ? Primitive.NO_HIT : share * inFrame.stretch;
    }

    /**
     * Takes what was found last if it is nearer than everything before; of equally near primitives it takes the one
     * listed first.
     */
    private void compare(Ray inFrame, int index) {
        Primitive candidate = nearest.primitive();
        if (candidate == null) {
            return;
        }
        double candidateShare = nearest.distance() / inFrame.stretch;
        if (candidateShare < share || candidateShare == share && (found == null || candidate.order() < found.order())) {
            found = candidate;
            distance = nearest.distance();
            share = candidateShare;
            frame = index;
        }
    }

    private boolean end() {
        nearest.resume(found, distance);
        nearest.forgetLeaf();
        return found != null;
    }

    /** The frame of the hit that was found last; that of the ray if there was none. */
    public int frame() {
        return frame;
    }

    /** The ray of that hit, in that frame. */
    public Ray ray() {
        return ray;
    }

    /** The frame in which the last search began. */
    public int startFrame() {
        return from;
    }

    /** Sets the memory to the event of the hit that was found last, in that frame. */
    public void event(Hit memory) {
        double length = share * start.stretch;
        memory.setPlace(
                start.x + length * start.dx,
                start.y + length * start.dy,
                start.z + length * start.dz,
                start.timeAt(length));
    }
}
