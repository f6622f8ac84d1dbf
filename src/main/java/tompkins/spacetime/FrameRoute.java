package tompkins.spacetime;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/**
 * The way from one inertial frame to another, as changes of frame one after the other through the frames that contain
 * them: nested motions are never made into one boost, because two boosts are a boost and a rotation. Immutable.
 */
public final class FrameRoute {

    private final Step[] steps;

    FrameRoute(List<Step> steps) {
        this.steps = steps.toArray(Step[]::new);
    }

    /**
     * A change of frame about an event that both frames know.
     *
     * @param from an event in the first frame
     * @param transformation changes differences of events
     * @param to the same event in the second frame
     */
    record Step(Event from, SpaceTimeTransformation transformation, Event to) {

        Step inverse() {
            return new Step(to, transformation.inverse(), from);
        }

        private Event transform(Event event) {
            return transformation.transform(event.minus(from)).plus(to);
        }

        private Ray transform(Ray ray, Ray memory) {
            memory.set(ray).move(-from.x(), -from.y(), -from.z(), -from.time());
            return transformation.transform(memory, memory).move(to.x(), to.y(), to.z(), to.time());
        }

        private void transform(RayPacket rays) {
            rays.shift(-from.x(), -from.y(), -from.z(), -from.time());
            transformation.transform(rays);
            rays.shift(to.x(), to.y(), to.z(), to.time());
        }
    }

    /** Number of changes of frame. */
    public int length() {
        return steps.length;
    }

    /** An event of the first frame, in the second. */
    public Event transform(Event event) {
        Event moved = event;
        for (Step step : steps) {
            moved = step.transform(moved);
        }
        return moved;
    }

    /** A difference of two events of the first frame, in the second: what is far away loses no digits in it. */
    public Event difference(Event difference) {
        Event moved = difference;
        for (Step step : steps) {
            moved = step.transformation.transform(moved);
        }
        return moved;
    }

    /** How place and time in the second frame change in one unit of the time of what rests in the first. */
    public Event worldLine() {
        return difference(new Event(0, 0, 0, 1));
    }

    /** Where a point that rests in the first frame is at a time of the second. */
    public Vector3d place(Vector3dc point, double time) {
        Event once = transform(new Event(point.x(), point.y(), point.z(), 0));
        Event pace = worldLine();
        return once.position().fma((time - once.time()) / pace.time(), pace.position());
    }

    /**
     * Makes {@code memory}, which may be the ray itself, the same ray in the second frame, where it starts on nothing.
     */
    public Ray transform(Ray ray, Ray memory) {
        memory.set(ray);
        for (Step step : steps) {
            step.transform(memory, memory);
        }
        return memory;
    }

    /** Takes each ray of a packet into the second frame. */
    public void transform(RayPacket rays) {
        for (Step step : steps) {
            step.transform(rays);
        }
    }
}
