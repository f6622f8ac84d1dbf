package tompkins.world;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector3dc;
import tompkins.light.Illumination;
import tompkins.light.LightShift;
import tompkins.light.Lighting;
import tompkins.light.RestingLight;
import tompkins.primitive.Primitive;
import tompkins.ray.Contact;
import tompkins.ray.Hit;
import tompkins.ray.Medium;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.search.ContactSearch;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.search.PacketSearch;
import tompkins.spacetime.TransformationLaw;

/**
 * What rays can meet: the objects and lamps of some frames. A ray is taken into each of them; its distances there are
 * given in units of the direction that it had at the camera, which are the same in all frames. One for each thread.
 */
public final class Surroundings extends Padded {

    private final ObjectTree[] trees;
    private final int[] filled;
    private final FrameRoutes routes;
    private final NearestHit nearest;
    private final RetardedLight light;
    private final Ray[] mapped;
    private final FramePacket[] packets;

    private final List<RestingLight> lights;
    private final TransformationLaw law;
    private final int home;
    private final Ray leaving = Ray.blank();

    /** Whether all objects and lamps rest in one frame. */
    private final boolean isOneFrame;

    /** The packets with rays that may meet something. */
    private final FramePacket[] open;

    private int openCount;
    private final Ray packetStart = Ray.blank();
    private RayPacket startRays;

    // of the search that is being made
    private Primitive found;
    private double distance;

    /** That distance, and how far something else may lie at the same place, as they are in all frames. */
    private double length;

    private double reach;
    private boolean shared;
    private Ray ray;
    private Ray start;

    /**
     * Some frames, with the memory of a thread.
     *
     * @param trees the objects of each frame by its number; null where nothing is searched
     * @param law of what moves; none if all rests, and light needs no carrier
     */
    public Surroundings(
            ObjectTree[] trees, List<Lamp> lamps, FrameRoutes routes, TransformationLaw law, RayCounts counts) {
        this.trees = trees;
        this.routes = routes;
        filled = filled(trees);
        this.law = law;
        int[] searched = IntStream.range(0, trees.length)
                .filter(frame -> trees[frame] != null)
                .toArray();
        home = searched[0];
        isOneFrame = searched.length == 1;
        lights = lamps.stream().map(Lamp::light).toList();
        nearest = new NearestHit(counts);
        light = new RetardedLight(trees, lamps, routes, law, counts);
        mapped = Stream.generate(Ray::blank).limit(trees.length).toArray(Ray[]::new);
        packets = new FramePacket[trees.length];
        open = new FramePacket[trees.length];
    }

    /**
     * One frame that is no part of a world.
     *
     * @param home its number
     */
    public static Surroundings ofOneFrame(
            int home,
            ObjectTree objects,
            List<RestingLight> lights,
            FrameRoutes routes,
            TransformationLaw law,
            RayCounts counts) {
        ObjectTree[] trees = new ObjectTree[home + 1];
        trees[home] = objects;
        List<Lamp> lamps =
                lights.stream().map(light -> new Lamp(light, home, 0)).toList();
        return new Surroundings(trees, lamps, routes, law, counts);
    }

    /** The numbers of the frames in which objects rest; the others hold lamps, or what moves in them. */
    static int[] filled(ObjectTree[] trees) {
        return IntStream.range(0, trees.length)
                .filter(frame -> trees[frame] != null && trees[frame].size() > 0)
                .toArray();
    }

    /** The rays of a packet in one frame, and the search for what they meet there. */
    private final class FramePacket {
        private final int frame;
        private final PacketSearch query;
        private RayPacket memory;
        private RayPacket rays;

        FramePacket(int frame) {
            this.frame = frame;
            query = new PacketSearch(trees[frame], nearest);
        }

        void begin(RayPacket from) {
            rays = from;
            if (from.frame() != frame) {
                memory = memory == null ? new RayPacket(RayPacket.MOST) : memory;
                rays = memory;
                rays.set(from);
                routes.transform(rays, frame);
            }
            query.begin(rays);
        }
    }

    /**
     * Begins a packet: searches for all its rays together as far as that helps, and forgets what was seen before, so
     * that the work for a packet depends on nothing else.
     */
    public void begin(RayPacket rays) {
        light.beginBlock();
        startRays = rays;
        openCount = 0;
        for (int i : filled) {
            if (packets[i] == null) {
                packets[i] = new FramePacket(i);
            }
            packets[i].begin(rays);
            if (packets[i].query.mayMeet()) {
                open[openCount++] = packets[i];
            }
        }
    }

    /** Whether a ray of that packet may meet something; false only if that is certain. */
    public boolean mayMeet(int index) {
        for (int i = 0; i < openCount; i++) {
            if (open[i].query.mayMeet(index)) {
                return true;
            }
        }
        return false;
    }

    /** As {@link #nearest(Ray, Hit)}, for a ray of that packet; asked in the order of the packet. */
    public Hit nearest(int index, Hit memory) {
        begin(packetStart);
        for (int i = 0; i < openCount; i++) {
            RayPacket rays = open[i].rays;
            PacketSearch query = open[i].query;
            if (!Double.isNaN(rays.dx[index]) && query.nearest(index, limit(rays.directionLength[index]))) {
                compare(query.ray());
            }
        }
        if (found == null) {
            return null;
        }
        start = ray.frame == startRays.frame() ? ray : startRays.copy(index, packetStart);
        return hit(memory);
    }

    /**
     * The nearest hit of a ray, in the frame of what it has hit; null if there is none.
     *
     * @param memory what the hit may be put into
     */
    public Hit nearest(Ray from, Hit memory) {
        begin(from);
        Contact next = from.contact == null ? null : from.contact.next();
        if (next != null) {
            return hit(next);
        }
        // nothing rests in the frame of the camera
        if (from.frame < trees.length && trees[from.frame] != null) {
            trees[from.frame].nearest(from, Primitive.NO_HIT, nearest);
            compare(from);
        }
        for (int i : filled) {
            if (i == from.frame) {
                continue;
            }
            Ray inFrame = routes.transform(from, i, mapped[i]);
            if (!Double.isNaN(inFrame.dx)) {
                trees[i].nearest(inFrame, limit(inFrame.directionLength), nearest);
                compare(inFrame);
            }
        }
        if (ray != from) {
            // the ray must stay as it is while others are searched for
            mapped[ray.frame] = Ray.blank();
        }
        return found == null ? null : hit(memory);
    }

    private void begin(Ray from) {
        start = from;
        ray = from;
        found = null;
        distance = Primitive.NO_HIT;
        length = Primitive.NO_HIT;
        reach = Primitive.NO_HIT;
        shared = false;
    }

    private double limit(double directionLength) {
        return found == null ? Primitive.NO_HIT : reach * directionLength;
    }

    /** The start in a frame, in memory of its own. */
    private Ray inFrame(int frame) {
        return frame == start.frame ? start : routes.transform(start, frame, Ray.blank());
    }

    /** Takes the nearest of a frame if it is nearer than all before; of equally near ones the one listed first. */
    private void compare(Ray inFrame) {
        Primitive candidate = nearest.primitive();
        if (candidate == null) {
            return;
        }
        double candidateLength = nearest.distance() / inFrame.directionLength;
        if (candidateLength > length
                || candidateLength == length && found != null && candidate.order() > found.order()) {
            shared |= candidateLength <= reach;
        } else {
            reach = nearest.reach() / inFrame.directionLength;
            shared = nearest.isShared() || found != null && length <= reach;
            found = candidate;
            distance = nearest.distance();
            length = candidateLength;
            ray = inFrame;
        }
    }

    /** The hit on what was found; where surfaces touch, that on the first layer that does something, or beyond. */
    private Hit hit(Hit memory) {
        Hit hit = given(found.hit(ray, distance, memory), length);
        if (!shared) {
            return hit;
        }
        ContactSearch search = new ContactSearch();
        for (int i : filled) {
            Ray inFrame = inFrame(i);
            if (!Double.isNaN(inFrame.dx)) {
                search.add(trees[i], inFrame, reach * inFrame.directionLength);
            }
        }
        Contact all = search.contact();
        if (all == null) {
            return hit;
        }
        Contact first = all.next();
        return first == null ? nearest(ray.past(hit, all), memory) : hit(first);
    }

    private Hit hit(Contact contact) {
        ray = inFrame(contact.hits().get(0).frame);
        Hit hit = contact.hit();
        return given(hit, hit.distance / ray.directionLength);
    }

    /** Gives a hit its ray, and its event in the frame in which that began. */
    private Hit given(Hit hit, double lengthAlong) {
        hit.of(ray);
        if (!isOneFrame || ray.frame != start.frame) {
            double along = lengthAlong * start.directionLength;
            hit.eventMemory()
                    .setPlace(
                            start.frame,
                            start.x + along * start.dx,
                            start.y + along * start.dy,
                            start.z + along * start.dz,
                            start.timeAt(along));
        }
        return hit;
    }

    /** The ways of light from the lamps to hits. */
    public Lighting lighting() {
        return light;
    }

    /** The light of the lamps; what becomes of it on its way to the camera may be null. */
    public Illumination illumination(LightShift shift) {
        return new Illumination(lights, light, shift);
    }

    /** The number of the frame in which rays come and go. */
    public int home() {
        return home;
    }

    /** A ray that meets nothing, in that frame. Memory that is reused. */
    public Ray leaving(Ray left) {
        return left.frame == home ? left : routes.transform(left, home, leaving);
    }

    /** Whether rays must know in which medium they are, because something moves. */
    public boolean keepsMedia() {
        return law == TransformationLaw.LORENTZ;
    }

    /** The proper velocity of the rest frame of a medium, in a frame. */
    public Vector3dc velocity(Medium medium, int frame) {
        return routes.motion(frame, medium.frame()).inFirst();
    }
}
