package tompkins.trace;

import java.util.List;
import java.util.function.Predicate;
import org.joml.Vector3dc;
import tompkins.light.Illumination;
import tompkins.light.RestingLight;
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
import tompkins.world.FrameRoutes;

/**
 * Follows rays among what surrounds them: the nearest hit decides, and what leaves the objects has escaped. One for
 * each thread.
 */
final class RayTracer extends Padded implements Tracer {

    private final Frame place;
    private final Surroundings surroundings;
    private final List<RestingLight> lights;
    private final Illumination illumination;
    private final FrameRoutes routes;
    private final EscapedLight escaped;
    private final int maximumDepth;
    private final RayCounts counts;
    private final PathObserver observer;
    private final Hit hitMemory = Hit.blank();
    private final Ray startMemory = Ray.blank();

    /**
     * A tracer.
     *
     * @param routes the ways between frames, if rays must know in which medium they are; null otherwise
     * @param escaped the light of rays that leave the surroundings
     * @param observer watches the rays; may be null
     */
    RayTracer(
            Frame place,
            Surroundings surroundings,
            List<RestingLight> lights,
            FrameRoutes routes,
            EscapedLight escaped,
            int maximumDepth,
            RayCounts counts,
            PathObserver observer) {
        this.place = place;
        this.surroundings = surroundings;
        this.lights = lights;
        illumination = new Illumination(lights, surroundings);
        this.routes = routes;
        this.escaped = escaped;
        this.maximumDepth = maximumDepth;
        this.counts = counts;
        this.observer = observer;
    }

    /** Begins a packet of rays that enter this frame. */
    void begin(RayPacket rays) {
        surroundings.begin(rays);
    }

    /** Whether light is shifted where it leaves a hit, by the frequency in the frame of the hit. */
    boolean shifts() {
        return surroundings.shifts();
    }

    /** The light along each ray that meets nothing, if it is the same for all; otherwise null. */
    Colour evenLight() {
        return escaped.evenLight();
    }

    /** Whether a ray of the packet may meet something. */
    boolean mayMeet(int place) {
        return surroundings.mayMeet(place);
    }

    /** The light that comes back along a ray of the packet. */
    Colour packetColour(RayPacket rays, int place) {
        counts.rays++;
        if (surroundings.nearest(place)) {
            return withEscaped(follow(surroundings.met(), true, hitMemory));
        }
        return surroundings.shifts()
                ? escaped.seen(rays.copy(place, startMemory), surroundings)
                : escaped.colour(rays, place);
    }

    /**
     * Follows a ray of the packet until it ends or leaves the objects of this frame.
     *
     * @return what it has brought; the ray that leaves is memory that is used again
     */
    TracedPath follow(RayPacket rays, int place) {
        counts.rays++;
        boolean hits = surroundings.nearest(place);
        return follow(hits ? surroundings.met() : rays.copy(place, startMemory), hits, hitMemory);
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
        boolean hits = surroundings.nearest(start);
        return withEscaped(follow(hits ? surroundings.met() : start, hits, Hit.blank()));
    }

    /** The colour of a ray that was followed, with what comes from behind the objects. */
    private Colour withEscaped(TracedPath path) {
        Ray left = path.escaped();
        if (left == null) {
            return path.light();
        }
        return path.light()
                .plus(
                        surroundings.shifts()
                                ? escaped.seen(left, surroundings)
                                : path.throughput().times(escaped.colour(left)));
    }

    /**
     * Follows a ray whose nearest hit has just been searched for. The memory is for its hits, each of which is dealt
     * with before the next.
     */
    private TracedPath follow(Ray start, boolean startHits, Hit memory) {
        Ray ray = start;
        boolean hits = startHits;
        Colour light = Colour.BLACK;
        Colour weight = start.weight;
        if (hits && place == Frame.SCENE) {
            counts.sceneHits++;
        }
        boolean first = true;
        while (hits) {
            Response response = respond(ray, surroundings.hit(memory));
            Colour own = response.light();
            light = first ? own : light.plus(surroundings.shifts() ? own : own.times(weight));
            first = false;
            Ray next = response.next();
            if (next == null || isGivenUp(next)) {
                return new TracedPath(light, weight, null);
            }
            weight = weight.times(response.factor());
            ray = surroundings.goesOn(next, weight);
            counts.rays++;
            hits = surroundings.nearest(ray);
            if (hits) {
                ray = surroundings.met();
            }
        }
        ray = surroundings.leaving(ray);
        if (observer != null) {
            observer.leaves(place, ray);
        }
        return new TracedPath(light, weight, ray);
    }

    private Response respond(Ray ray, Hit hit) {
        Primitive primitive = (Primitive) hit.boundary;
        if (observer != null) {
            observer.hits(place, ray, hit, primitive);
        }
        if (hit.contact != null && hit.contact.hits().size() > 1) {
            return Refractive.respond(
                    ray,
                    hit,
                    media(hit, each -> each.cosine(ray) >= 0),
                    media(hit, each -> each.cosine(ray) < 0),
                    this);
        }
        return hit.runs
                ? new PointTracer(this, surroundings, lights, hit).respond(primitive.surface(), ray)
                : primitive.surface().respond(ray, hit, this);
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
        return routes != null;
    }

    @Override
    public Vector3dc velocity(Medium medium, int frame) {
        return routes.motion(frame, medium.frame()).inFirst();
    }
}
