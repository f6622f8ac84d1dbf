package tompkins.trace;

import org.joml.Vector3dc;
import tompkins.light.Illumination;
import tompkins.light.Lighting;
import tompkins.light.Sightline;
import tompkins.primitive.Primitive;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Medium;
import tompkins.ray.Ray;
import tompkins.spacetime.MomentaryRestFrame;
import tompkins.surface.Response;
import tompkins.surface.Surface;
import tompkins.surface.Tracer;

/**
 * What a surface that turns may ask, in the frame in which the point that is hit rests for a moment. Rays that go on
 * return to the frame around it, and the ways to lamps come from there. Made for one hit.
 */
final class MomentaryFrameTracer implements Tracer, Lighting {

    private final RayTracer outside;
    private final Lighting lighting;
    private final MomentaryRestFrame point;
    private final Hit hit;
    private final Illumination illumination;
    private final Sightline found = new Sightline();
    private final Ray way = Ray.blank();

    MomentaryFrameTracer(RayTracer outside, Lighting lighting, Hit hit) {
        this.outside = outside;
        this.lighting = lighting;
        this.hit = hit;
        point = new MomentaryRestFrame(
                hit, ((Primitive) hit.boundary).restFrame().rotation().law());
        illumination = outside.illumination().by(this);
    }

    /** What the surface makes of the ray that has hit it. */
    Response respond(Surface surface) {
        Ray inside = point.enter(hit.ray);
        point.enterHit();
        Response response = surface.respond(inside, hit, this);
        return response.next() == null
                ? response
                : new Response(response.light(), response.factor(), point.leave(response.next()));
    }

    @Override
    public Colour colour(Ray ray) {
        return outside.colour(point.leave(ray));
    }

    @Override
    public Illumination illumination() {
        return illumination;
    }

    @Override
    public boolean keepsMedia() {
        return outside.keepsMedia();
    }

    @Override
    public Vector3dc velocity(Medium medium, int frame) {
        return outside.velocity(medium, frame);
    }

    @Override
    public boolean find(int source, Hit at, Sightline sight) {
        if (!lighting.find(source, at, found)) {
            return false;
        }
        double length = found.length;
        if (length == 0) {
            return false;
        }
        point.turn(way.setShadow(at, found.x / length, found.y / length, found.z / length, found.slowness));
        double stretched = length * way.directionLength;
        sight.set(
                way.dx * stretched,
                way.dy * stretched,
                way.dz * stretched,
                found.dopplerFactor * way.frequency,
                way.slowness,
                found.emission);
        return true;
    }

    @Override
    public boolean isClear(int source, Hit at, Sightline sight) {
        return lighting.isClear(source, at, found);
    }
}
