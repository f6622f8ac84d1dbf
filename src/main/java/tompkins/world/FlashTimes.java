package tompkins.world;

import java.util.Comparator;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.light.Pulse;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.spacetime.Event;
import tompkins.spacetime.TransformationLaw;

/** When, in the time of the camera, flashes light what a ray has hit. */
public final class FlashTimes {

    private final World world;
    private final FrameRoutes routes;
    private final boolean hasOneCarrier;

    /** The times in a world. */
    public FlashTimes(World world, FrameRoutes routes, TransformationLaw law) {
        this.world = world;
        this.routes = routes;
        hasOneCarrier = law == TransformationLaw.GALILEAN;
    }

    /**
     * When the surface that a ray has hit is seen lit by one flash of a lamp, if the shutter opens sooner or later and
     * the ray keeps its direction in the camera frame. Exact where the surface is flat; elsewhere its tangent plane
     * stands for it.
     *
     * @param ray a ray that has come from the camera without a mirror or glass on the way
     * @param cycle the number of the flash, as {@link Pulse#cycle} counts
     */
    public List<LitSpan> of(int source, Pulse flash, double cycle, Ray ray, Hit hit) {
        Hit event = hit.event == null ? hit : hit.event;
        // in one unit of camera time the event goes with the camera, and along the ray to where the surface is
        Event camera = routes.route(routes.camera(), hit.frame).worldLine();
        double across = camera.x() * hit.normalX + camera.y() * hit.normalY + camera.z() * hit.normalZ;
        double farther = -across / hit.cosine(ray);
        Event along = new Event(farther * ray.dx, farther * ray.dy, farther * ray.dz, -farther * ray.slowness);
        Event shift = camera.plus(along);
        double begin = flash.start() + cycle * flash.period();
        Lamp lamp = world.lamps().get(source);
        LightTimes times = (hasOneCarrier ? IntStream.of(routes.camera()) : IntStream.of(lamp.frame(), event.frame))
                .mapToObj(frame -> lightTimes(frame, lamp, begin, begin + flash.duration(), hit, shift))
                .min(Comparator.comparingDouble(LightTimes::rounding))
                .orElseThrow();
        double square = hasOneCarrier
                ? product(times.shift, times.shift)
                : 2 * product(camera, along) - 1 + farther * farther * (1 - ray.slowness * ray.slowness);
        // when the camera gets to the surface, or came from it, the ray does not meet it any more
        double reached = -hit.distance / farther;
        return LitSpan.of(times.begin, times.end, times.met, times.shift, square).stream()
                .map(span -> farther > 0
                        ? new LitSpan(Math.max(span.from(), reached), span.to())
                        : farther < 0 ? new LitSpan(span.from(), Math.min(span.to(), reached)) : span)
                .filter(span -> span.from() < span.to())
                .toList();
    }

    private LightTimes lightTimes(int frame, Lamp lamp, double begin, double end, Hit hit, Event shift) {
        Vector3dc place = lamp.position();
        Hit event = hit.event == null ? hit : hit.event;
        Event[] ends = DoubleStream.of(begin, end)
                .mapToObj(time -> new Event(place.x(), place.y(), place.z(), time + lamp.properTimeZero()))
                .map(routes.route(lamp.frame(), frame)::transform)
                .toArray(Event[]::new);
        Event met = routes.route(event.frame, frame).transform(new Event(event.x, event.y, event.z, event.time));
        return new LightTimes(
                ends[0], ends[1], met, routes.route(hit.frame, frame).difference(shift));
    }

    /** Switching on, switching off, the hit, and its change in a unit of the camera's time, in one frame. */
    private record LightTimes(Event begin, Event end, Event met, Event shift) {

        /** By how much rounding moves the times: at high speed one frame can be many times better than another. */
        double rounding() {
            Vector3d way = met.minus(begin).position();
            double rate = shift.time() - way.dot(shift.position()) / way.length();
            return (size(begin) + size(end) + size(met)) / Math.abs(rate);
        }

        private static double size(Event event) {
            return event.position().length() + Math.abs(event.time());
        }
    }

    private static double product(Event one, Event other) {
        return one.position().dot(other.position()) - one.time() * other.time();
    }
}
