package tompkins.trace;

import java.util.List;
import tompkins.light.Illumination;
import tompkins.light.LightSource;
import tompkins.light.Visibility;
import tompkins.primitive.Primitive;
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
import tompkins.surface.Response;
import tompkins.surface.Surface;
import tompkins.surface.Tracer;

/**
 * Follows rays among the objects of one frame: the nearest hit decides, and what leaves the objects goes beyond. One
 * for each thread and frame.
 */
final class RayTracer implements Tracer, Visibility {

    private final Frame frame;
    private final ObjectTree objects;
    private final Illumination illumination;
    private final LampShadows[] lightGrids;
    private final Beyond beyond;
    private final int maximumDepth;
    private final RayCounts counts;
    private final PathObserver witness;
    private final NearestHit nearest;
    private final Hit hitMemory = Hit.blank();
    private final Ray startMemory = Ray.blank();
    private final Ray shadowMemory = Ray.blank();

    // of the ray followed last
    private Colour sum = Colour.BLACK;
    private Colour factor = Colour.WHITE;

    /** What threw the last shadow: it often throws the next one, too. */
    private Primitive lastShadow;

    /** A tracer of one frame; the witness may be null. */
    RayTracer(
            Frame frame,
            ObjectTree objects,
            List<LightSource> lights,
            LampShadows[] lightGrids,
            Beyond beyond,
            int maximumDepth,
            RayCounts counts,
            PathObserver witness) {
        this.frame = frame;
        this.objects = objects;
        illumination = new Illumination(lights, this);
        this.lightGrids = lightGrids;
        this.beyond = beyond;
        this.maximumDepth = maximumDepth;
        this.counts = counts;
        nearest = new NearestHit(counts);
        this.witness = witness;
    }

    /** Begins a block of rays: forgets what was seen before, so that the work for a block depends on nothing else. */
    void beginBlock() {
        lastShadow = null;
        nearest.forgetLeaf();
    }

    @Override
    public Colour colour(Ray branch) {
        if (witness == null) {
            return colourOf(branch);
        }
        witness.branches();
        Colour colour = colourOf(branch);
        witness.returns();
        return colour;
    }

    /** The light that comes back along a ray that is no branch of another in this frame. */
    Colour colourOf(Ray start) {
        if (isGivenUp(start)) {
            return Colour.BLACK;
        }
        counts.rays++;
        return colour(start, objects.nearest(start, nearest), Hit.blank());
    }

    /**
     * Follows a ray of a block until it ends or leaves the objects of this frame.
     *
     * @return what leaves, in memory that is used again, or null; {@link #sum()} and {@link #factor()} tell of the way
     */
    Ray follow(RayPacket rays, int place) {
        counts.rays++;
        Ray start = rays.copy(place, startMemory);
        return follow(start, objects.nearest(start, nearest), hitMemory);
    }

    /** The light that the ray followed last has brought by itself. */
    Colour sum() {
        return sum;
    }

    /** What becomes of the light that comes back to where that ray has left. */
    Colour factor() {
        return factor;
    }

    /** As {@link #colourOf(Ray)}, for the ray at a place of the block for which the search was made. */
    Colour colour(RayPacket rays, int place, PacketSearch search) {
        counts.rays++;
        if (!search.mayMeet(place)) {
            return beyond.colour(rays, place);
        }
        Ray start = rays.copy(place, startMemory);
        return colour(start, search.nearest(start, place, nearest), hitMemory);
    }

    /** As {@link #colourOf(Ray)}, for one of the rays for which the nodes were found. */
    Colour colour(RayPacket rays, int place, EntryNodes entries) {
        counts.rays++;
        Ray start = rays.copy(place, startMemory);
        return colour(start, objects.nearest(start, entries, nearest), hitMemory);
    }

    /** As {@link #colourOf(Ray)}, for a ray of a block. */
    Colour colour(RayPacket rays, int place) {
        return withBeyond(follow(rays, place));
    }

    /** Looks for the nodes through which some rays enter the tree; false if each must search from its root. */
    boolean find(EntryNodes entries, RayPacket rays, int from, int to) {
        return entries.find(objects, rays, from, to);
    }

    /** Looks for the primitives that the rays of a block can meet; false if all must be searched. */
    boolean find(PacketSearch search, RayPacket rays) {
        return search.find(objects, rays, nearest);
    }

    private Colour colour(Ray start, boolean hits, Hit memory) {
        return withBeyond(follow(start, hits, memory));
    }

    /** The colour of the ray followed last: of what has left the objects, or null, in memory that is used again. */
    private Colour withBeyond(Ray left) {
        // what stands in sum and factor is taken before anything else is followed
        return left == null ? sum : sum.plus(factor.times(beyond.colour(left)));
    }

    /**
     * Follows a ray whose nearest hit has just been searched. The memory is for its hits, of which each is over before
     * the next.
     */
    private Ray follow(Ray start, boolean startHits, Hit memory) {
        Ray ray = start;
        boolean hits = startHits;
        Colour light = Colour.BLACK;
        Colour share = Colour.WHITE;
        if (hits && frame == Frame.SCENE) {
            counts.sceneHits++;
        }
        while (hits) {
            Hit hit = nearest.hit(ray, memory);
            Surface surface = nearest.primitive().surface();
            if (witness != null) {
                witness.hits(frame, ray, hit, nearest.primitive());
            }
            Response response = surface.respond(ray, hit, this);
            light = ray == start
                    ? response.light()
                    : light.plus(response.light().times(share));
            ray = response.next();
            if (ray == null || isGivenUp(ray)) {
                sum = light;
                return null;
            }
            share = share.times(response.factor());
            counts.rays++;
            hits = objects.nearest(ray, nearest);
        }
        if (witness != null) {
            witness.leaves(frame, ray);
        }
        sum = light;
        factor = share;
        return ray;
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
    public boolean isClear(Hit from, double x, double y, double z) {
        counts.shadowRays++;
        double toX = x - from.x;
        double toY = y - from.y;
        double toZ = z - from.z;
        double distance = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
        toX /= distance;
        toY /= distance;
        toZ /= distance;
        for (LampShadows grid : lightGrids) {
            if (grid.isOf(x, y, z)) {
                return !grid.shadows(from, toX, toY, toZ, distance, shadowMemory, counts);
            }
        }
        Ray ray = shadowMemory.setShadow(from, toX, toY, toZ);
        if (lastShadow != null && lastShadow.shadows(ray, distance)) {
            return false;
        }
        lastShadow = objects.shadow(ray, distance, nearest);
        return lastShadow == null;
    }

    @Override
    public Illumination illumination() {
        return illumination;
    }
}
