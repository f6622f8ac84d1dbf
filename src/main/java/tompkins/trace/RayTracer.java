package tompkins.trace;

import java.util.List;
import java.util.function.Predicate;
import org.joml.Vector3dc;
import tompkins.light.Illumination;
import tompkins.light.LightShift;
import tompkins.primitive.Primitive;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Medium;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.surface.Refractive;
import tompkins.surface.Response;
import tompkins.surface.Tracer;
import tompkins.world.Surroundings;

/**
 * Follows rays among what surrounds them: the nearest hit decides, and what leaves the objects has escaped. One for
 * each thread.
 */
final class RayTracer extends Padded implements Tracer {

    private final Surroundings surroundings;
    private final Illumination illumination;
    private final LightShift shift;
    private final EscapedLight escaped;
    private final int maximumDepth;
    private final RayCounts counts;
    private final PathObserver observer;
    private final Hit hitMemory = Hit.blank();
    private final Ray startMemory = Ray.blank();

    /**
     * A tracer.
     *
     * @param shift what becomes of light on its way to the camera, if that depends on the frame of the hit that it
     *     leaves; null otherwise
     * @param escaped the light of rays that leave the surroundings
     * @param observer watches the rays; may be null
     */
    RayTracer(
            Surroundings surroundings,
            LightShift shift,
            EscapedLight escaped,
            int maximumDepth,
            RayCounts counts,
            PathObserver observer) {
        this.surroundings = surroundings;
        this.shift = shift;
        illumination = surroundings.illumination(shift);
        this.escaped = escaped;
        this.maximumDepth = maximumDepth;
        this.counts = counts;
        this.observer = observer;
    }

    /** Begins a packet of rays that enter this frame. */
    void begin(RayPacket rays) {
        surroundings.begin(rays);
    }

    /** The light of rays that meet nothing, if it is the same for all; otherwise null. */
    Colour evenLight() {
        return escaped.evenLight();
    }

    /** Whether a ray of the packet may meet something; false only if that is certain. */
    boolean mayMeet(int index) {
        return surroundings.mayMeet(index);
    }

    /** The light that comes back along a ray of the packet. */
    Colour packetColour(RayPacket rays, int index) {
        counts.rays++;
        Hit hit = surroundings.nearest(index, hitMemory);
        return hit == null ? escaped.colour(rays, index) : withEscaped(follow(hit.ray, hit, hitMemory));
    }

    /**
     * Follows a ray of the packet until it ends or leaves the objects of this frame.
     *
     * @return what it has brought; the ray that leaves is memory that is reused
     */
    TracedPath follow(RayPacket rays, int index) {
        counts.rays++;
        Hit hit = surroundings.nearest(index, hitMemory);
        return follow(hit == null ? rays.copy(index, startMemory) : hit.ray, hit, hitMemory);
    }

    @Override
    public Colour colour(Ray branch) {
        if (observer == null) {
            return colourOf(branch);
        }
        observer.branches();
        Colour colour = colourOf(branch);
        observer.returns();
        return colour;
    }

    /** The light that comes back along a ray. */
    Colour colourOf(Ray start) {
        if (isGivenUp(start)) {
            return Colour.BLACK;
        }
        counts.rays++;
        Hit memory = Hit.blank();
        return withEscaped(follow(start, surroundings.nearest(start, memory), memory));
    }

    /** The colour of a ray that was followed, with what comes from behind the objects. */
    private Colour withEscaped(TracedPath path) {
        if (path.escaped() == null) {
            return path.light();
        }
        Colour behind = escaped.colour(path.escaped());
        return path.light().plus(shift == null ? path.throughput().times(behind) : behind);
    }

    /** Follows a ray from its nearest hit on, if any. The memory holds one hit after the other. */
    private TracedPath follow(Ray start, Hit first, Hit memory) {
        Ray ray = start;
        Colour light = Colour.BLACK;
        Colour weight = start.weight;
        if (first != null && surroundings.home() == 0) {
            counts.sceneHits++;
        }
        for (Hit hit = first; hit != null; hit = surroundings.nearest(ray, memory)) {
            Response response = respond(hit);
            Colour own = response.light();
            light = ray == start ? own : light.plus(shift == null ? own.times(weight) : own);
            Ray next = response.next();
            if (next == null || isGivenUp(next)) {
                return new TracedPath(light, weight, null);
            }
            weight = weight.times(response.factor());
            // light is shifted where it leaves a hit, so the ray must know what becomes of it on the way before that
            ray = shift == null ? next : next.weighted(weight);
            counts.rays++;
        }
        ray = surroundings.leaving(ray);
        if (observer != null) {
            observer.leaves(ray);
        }
        return new TracedPath(light, weight, ray);
    }

    private Response respond(Hit hit) {
        Primitive primitive = (Primitive) hit.boundary;
        if (observer != null) {
            observer.hits(hit);
        }
        if (hit.contact != null && hit.contact.hits().size() > 1) {
            return Refractive.respond(
                    hit.ray,
                    hit,
                    media(hit, each -> each.cosine(hit.ray) >= 0),
                    media(hit, each -> each.cosine(hit.ray) < 0),
                    this);
        }
        return hit.pointMoves
                ? new MomentaryFrameTracer(this, surroundings.lighting(), hit).respond(primitive.surface())
                : primitive.surface().respond(hit.ray, hit, this);
    }

    /** The boundaries of media in the layer of a hit that are met as wanted. */
    private static List<Refractive> media(Hit hit, Predicate<Hit> wanted) {
        return hit.contact.hits().stream()
                .filter(wanted)
                .map(each -> (Refractive) ((Primitive) each.boundary).surface())
                .toList();
    }

    private boolean isGivenUp(Ray ray) {
        if (observer != null && observer.hasSeenEnough()) {
            return true;
        }
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
    public Illumination illumination() {
        return illumination;
    }

    @Override
    public boolean keepsMedia() {
        return surroundings.keepsMedia();
    }

    @Override
    public Vector3dc velocity(Medium medium, int frame) {
        return surroundings.velocity(medium, frame);
    }
}
