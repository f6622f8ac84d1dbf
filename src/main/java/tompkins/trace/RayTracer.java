package tompkins.trace;

import java.util.List;
import tompkins.light.LightSource;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayBlock;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.Candidates;
import tompkins.sceneobject.EntryNodes;
import tompkins.sceneobject.LightGrid;
import tompkins.sceneobject.NearestHit;
import tompkins.sceneobject.ObjectTree;
import tompkins.sceneobject.Primitive;
import tompkins.surface.Response;
import tompkins.surface.Surface;
import tompkins.surface.Tracer;

/**
 * Follows rays among the objects of one frame: the nearest hit decides, and what leaves the objects goes beyond. One for each
 * thread and frame.
 */
final class RayTracer implements Tracer {

    /**
     * A ray that can bring less than this share of the sample's light is ended (see the charts of the depth in
     * docs/speed-and-accuracy.md).
     */
    private static final double FAINTEST = 1.0 / 1024;

    private final Frame frame;
    private final ObjectTree objects;
    private final List<LightSource> lights;
    private final LightGrid[] lightGrids;
    private final Beyond beyond;
    private final int maximumDepth;
    private final RayCounts counts;
    private final RayWitness witness;
    private final NearestHit nearest = new NearestHit();
    private final Ray startMemory = Ray.blank();
    private final Ray shadowMemory = Ray.blank();

    /** What threw the last shadow: it often throws the next one, too. */
    private Primitive lastShadow;

    /** A tracer of one frame; the witness may be null. */
    RayTracer(
            Frame frame,
            ObjectTree objects,
            List<LightSource> lights,
            LightGrid[] lightGrids,
            Beyond beyond,
            int maximumDepth,
            RayCounts counts,
            RayWitness witness) {
        this.frame = frame;
        this.objects = objects;
        this.lights = lights;
        this.lightGrids = lightGrids;
        this.beyond = beyond;
        this.maximumDepth = maximumDepth;
        this.counts = counts;
        this.witness = witness;
    }

    @Override
    public Colour colour(Ray start) {
        if (isGivenUp(start)) {
            return Colour.BLACK;
        }
        counts.rays++;
        return colour(start, objects.nearest(start, nearest));
    }

    /** As {@link #colour(Ray)}, for the ray at a place of the block for which candidates were found. */
    Colour colour(RayBlock rays, int place, Candidates candidates) {
        counts.rays++;
        if (!candidates.mayMeet(place)) {
            return beyond.colour(rays, place);
        }
        Ray start = rays.copy(place, startMemory);
        return colour(start, candidates.nearest(start, place, nearest));
    }

    /** As {@link #colour(Ray)}, for one of the rays for which the nodes were found. */
    Colour colour(RayBlock rays, int place, EntryNodes entries) {
        counts.rays++;
        Ray start = rays.copy(place, startMemory);
        return colour(start, objects.nearest(start, entries, nearest));
    }

    /** Looks for the nodes through which some rays enter the tree; false if each must search from its root. */
    boolean find(EntryNodes entries, RayBlock rays, int from, int to) {
        return entries.find(objects, rays, from, to);
    }

    /** Looks for the primitives that some rays can meet; false if all must be searched. */
    boolean find(Candidates candidates, RayBlock rays) {
        lastShadow = null;
        return candidates.find(objects, rays);
    }

    /** Follows a ray whose nearest hit has just been searched. */
    private Colour colour(Ray start, boolean startHits) {
        Ray ray = start;
        boolean hits = startHits;
        Colour sum = Colour.BLACK;
        Colour factor = Colour.WHITE;
        while (true) {
            if (!hits) {
                return ray == start
                        ? beyond.colour(ray)
                        : sum.plus(beyond.colour(ray).times(factor));
            }
            Hit hit = nearest.hit(ray);
            Surface surface = nearest.primitive().surface();
            if (witness != null) {
                witness.hits(frame, ray, hit, surface);
            }
            Response response = surface.respond(ray, hit, this);
            if (ray == start && response.next() == null) {
                return response.light();
            }
            sum = sum.plus(response.light().times(factor));
            Ray next = response.next();
            if (next == null || isGivenUp(next)) {
                return sum;
            }
            factor = factor.times(response.factor());
            ray = next;
            counts.rays++;
            hits = objects.nearest(ray, nearest);
        }
    }

    private boolean isGivenUp(Ray ray) {
        if (ray.weight < FAINTEST) {
            counts.tooFaint++;
            return true;
        }
        if (ray.generation > maximumDepth) {
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
        for (LightGrid grid : lightGrids) {
            if (grid.isOf(x, y, z)) {
                return !grid.shadows(from, toX, toY, toZ, distance, shadowMemory, nearest);
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
    public List<LightSource> lights() {
        return lights;
    }

    /** Nodes and primitives that were looked at so far. */
    NearestHit work() {
        return nearest;
    }
}
