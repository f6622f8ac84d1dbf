package tompkins.world;

import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpaceTimeTransformation;

/** A change of frame about an event that both frames know. Immutable. */
final class FrameStep {

    private final Event from;
    private final SpaceTimeTransformation transformation;
    private final Event to;

    /**
     * A change of frame.
     *
     * @param from an event in the first frame
     * @param transformation changes differences of events
     * @param to the same event in the second frame
     */
    FrameStep(Event from, SpaceTimeTransformation transformation, Event to) {
        this.from = from;
        this.transformation = transformation;
        this.to = to;
    }

    /** The way back. */
    FrameStep inverse() {
        return new FrameStep(to, transformation.inverse(), from);
    }

    Event transform(Event event) {
        return transformation.transform(event.minus(from)).plus(to);
    }

    /** Makes {@code memory}, which may be the ray itself, the same ray in the second frame. */
    Ray transform(Ray ray, Ray memory) {
        memory.set(ray).move(-from.x(), -from.y(), -from.z(), -from.time());
        return transformation.transform(memory, memory).move(to.x(), to.y(), to.z(), to.time());
    }

    void transform(RayPacket rays) {
        shift(rays, -from.x(), -from.y(), -from.z(), -from.time());
        transformation.transform(rays);
        shift(rays, to.x(), to.y(), to.z(), to.time());
    }

    private static void shift(RayPacket rays, double x, double y, double z, double time) {
        if (x == 0 && y == 0 && z == 0 && time == 0) {
            return;
        }
        for (int i = 0; i < rays.count(); i++) {
            rays.x[i] += x;
            rays.y[i] += y;
            rays.z[i] += z;
            rays.time[i] += time;
        }
    }
}
