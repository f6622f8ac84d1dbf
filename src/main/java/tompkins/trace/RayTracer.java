package tompkins.trace;

import java.util.List;
import tompkins.light.Illumination;
import tompkins.light.LightSource;
import tompkins.light.Lighting;
import tompkins.light.Sightline;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.search.EntryNodes;
import tompkins.search.LampShadows;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.search.PacketSearch;
import tompkins.search.TreeParts;
import tompkins.surface.Response;
import tompkins.surface.Surface;
import tompkins.surface.Tracer;

/**
 * Follows rays among the objects of one frame, and among everything that moves in it: the nearest hit decides, and what
 * leaves the objects goes beyond them. One for each thread.
 */
final class RayTracer implements Tracer, Lighting {

    private final Frame place;
    private final ObjectTree objects;
    private final Illumination illumination;
    private final RestingLamps restingLamps;

    /** The frames that move in this one, or null if there are none. */
    private final MovingWorld movingWorld;

    private final Beyond beyond;
    private final int maximumDepth;
    private final RayCounts counts;
    private final PathObserver observer;
    private final NearestHit nearest;
    private final Hit hitMemory = Hit.blank();
    private final Ray startMemory = Ray.blank();

    /** The number of the frame of the present hit; 0 is that of this tracer. */
    private int frame;

    /** The event of that hit, in the frame in which its ray has begun, if something moves. */
    private Hit event = Hit.blank();

    private int eventFrame;

    /** The factor of the light of that hit on its way to the camera, if light is shifted as it leaves a hit. */
    private Colour way = Colour.WHITE;

    /**
     * A tracer.
     *
     * @param lampShadows what each of the lights sees of the objects, or null for those of which that is not prepared
     * @param movingWorld what moves in the frame; null if nothing does
     * @param observer watches the rays; may be null
     */
    RayTracer(
            Frame place,
            ObjectTree objects,
            List<LightSource> lights,
            LampShadows[] lampShadows,
            MovingWorld movingWorld,
            Beyond beyond,
            int maximumDepth,
            RayCounts counts,
            NearestHit nearest,
            PathObserver observer) {
        this.place = place;
        this.objects = objects;
        illumination = new Illumination(lights, this);
        restingLamps = new RestingLamps(objects, lights, lampShadows, counts, nearest);
        this.movingWorld = movingWorld;
        this.beyond = beyond;
        this.maximumDepth = maximumDepth;
        this.counts = counts;
        this.nearest = nearest;
        this.observer = observer;
    }

    /** Begins a packet: forgets what was seen before, so that the work for a packet depends on nothing else. */
    void beginBlock() {
        restingLamps.forget();
        nearest.forgetLeaf();
        if (movingWorld != null) {
            movingWorld.beginBlock();
        }
    }

    /** What moves in the frame; null if nothing does. */
    MovingWorld movingWorld() {
        return movingWorld;
    }

    @Override
    public Colour colour(Ray branch) {
        int before = frame;
        Colour wayBefore = way;
        Hit eventBefore = event;
        int eventFrameBefore = eventFrame;
        if (movingWorld != null) {
            event = Hit.blank();
        }
        if (observer != null) {
            observer.branches();
        }
        Colour colour = colourOf(branch, before);
        if (observer != null) {
            observer.returns();
        }
        frame = before;
        way = wayBefore;
        event = eventBefore;
        eventFrame = eventFrameBefore;
        return colour;
    }

    /** The light that comes back along a ray that enters this frame. */
    Colour colourOf(Ray start) {
        way = Colour.WHITE;
        return colourOf(start, 0);
    }

    private Colour colourOf(Ray start, int startFrame) {
        if (isGivenUp(start)) {
            return Colour.BLACK;
        }
        counts.rays++;
        frame = startFrame;
        return withBeyond(follow(start, search(start), Hit.blank()));
    }

    private boolean search(Ray ray) {
        return movingWorld == null
                ? objects.nearest(ray, nearest)
                : movingWorld.search().nearest(ray, frame);
    }

    /**
     * Follows a ray of a packet until it ends or leaves the objects of this frame.
     *
     * @return what it has brought; the ray that leaves is memory that is used again
     */
    Followed follow(RayPacket rays, int index) {
        counts.rays++;
        frame = 0;
        Ray start = rays.copy(index, startMemory);
        return follow(start, search(start), hitMemory);
    }

    /** The light that comes back along the ray at a place of the packet for which the search was made. */
    Colour packetColour(RayPacket rays, int index, PacketSearch search) {
        counts.rays++;
        if (!search.mayMeet(index)) {
            return beyond.colour(rays, index);
        }
        Ray start = rays.copy(index, startMemory);
        return withBeyond(follow(start, search.nearest(start, index, nearest), hitMemory));
    }

    /** The light that comes back along one of the rays for which the nodes were found. */
    Colour entryColour(RayPacket rays, int index, EntryNodes entries) {
        counts.rays++;
        Ray start = rays.copy(index, startMemory);
        return withBeyond(follow(start, objects.nearest(start, entries, nearest), hitMemory));
    }

    /** The light that comes back along a ray of the packet for which all frames are searched. */
    Colour movingColour(RayPacket rays, int index) {
        counts.rays++;
        frame = 0;
        way = Colour.WHITE;
        if (!movingWorld.search().nearest(index)) {
            Colour far = beyond.colour(rays, index);
            return shifts() ? movingWorld.seen(far, rays.frequency[index], 1) : far;
        }
        return withBeyond(follow(movingWorld.search().ray(), true, hitMemory));
    }

    /** The light that comes back along a ray of a packet, which is searched for alone. */
    Colour singleColour(RayPacket rays, int index) {
        return withBeyond(follow(rays, index));
    }

    /** Looks for the nodes through which some rays enter the tree; false if each must search from its root. */
    boolean find(EntryNodes entries, TreeParts parts, RayPacket rays, int from, int to) {
        return entries.find(objects, parts, rays, from, to);
    }

    /** Looks for what the rays of a packet meet; null if it was found, otherwise where each ray must search. */
    TreeParts find(PacketSearch search, RayPacket rays) {
        return search.find(objects, rays, nearest);
    }

    /** The colour of a ray that was followed, with what comes from beyond the objects. */
    private Colour withBeyond(Followed path) {
        Ray left = path.left();
        if (left == null) {
            return path.light();
        }
        Colour far = path.factor().times(beyond.colour(left));
        return path.light().plus(shifts() ? movingWorld.seen(far, left.frequency, 1) : far);
    }

    /**
     * Follows a ray whose nearest hit has just been searched. The memory is for its hits, each of which is dealt with
     * before the next.
     */
    private Followed follow(Ray start, boolean startHits, Hit memory) {
        Ray ray = start;
        boolean hits = startHits;
        Colour light = Colour.BLACK;
        // the surface that asked for a branch weakens its light, unless that is shifted where it begins
        Colour share = shifts() ? way : Colour.WHITE;
        if (hits && place == Frame.SCENE) {
            counts.sceneHits++;
        }
        boolean first = true;
        while (hits) {
            if (movingWorld != null) {
                ray = movingWorld.search().ray();
                frame = movingWorld.search().frame();
                movingWorld.search().event(event);
                eventFrame = movingWorld.search().startFrame();
                way = share;
            }
            Hit hit = nearest.hit(ray, memory);
            Surface surface = nearest.primitive().surface();
            if (observer != null) {
                observer.hits(
                        place,
                        frame,
                        ray,
                        hit,
                        nearest.primitive(),
                        movingWorld == null ? hit : event,
                        movingWorld == null ? frame : eventFrame);
            }
            Response response = surface.respond(ray, hit, this);
            light = first
                    ? response.light()
                    : light.plus(shifts() ? response.light() : response.light().times(share));
            first = false;
            ray = response.next();
            if (ray == null || isGivenUp(ray)) {
                return new Followed(light, share, null);
            }
            share = share.times(response.factor());
            counts.rays++;
            hits = search(ray);
        }
        if (movingWorld != null && frame != 0) {
            ray = movingWorld.inScene(frame, ray);
            frame = 0;
        }
        if (observer != null) {
            observer.leaves(place, ray);
        }
        return new Followed(light, share, ray);
    }

    private boolean isGivenUp(Ray ray) {
        if (ray.throughput < Ray.FAINTEST) {
            counts.giveUp(ray.throughput);
            return true;
        }
        if (ray.depth > maximumDepth) {
            counts.tooDeep++;
            return true;
        }
        return false;
    }

    @Override
    public boolean find(int source, Hit hit, Sightline sight) {
        if (movingWorld != null) {
            return movingWorld.lampWays().find(source, frame, hit, eventFrame, event, sight);
        }
        restingLamps.find(source, hit, sight);
        return true;
    }

    @Override
    public boolean isClear(int source, Hit from, Sightline sight) {
        if (movingWorld != null) {
            return movingWorld.lampWays().isClear(source, frame, from, eventFrame, event, sight);
        }
        return restingLamps.isClear(source, from, sight);
    }

    @Override
    public boolean shifts() {
        return movingWorld != null && movingWorld.shifts();
    }

    @Override
    public Colour seen(Colour light, Ray ray, double dopplerFactor) {
        return movingWorld.seen(light.times(way), ray.frequency, dopplerFactor);
    }

    @Override
    public Illumination illumination() {
        return illumination;
    }
}
