package tompkins.spacetime;

import org.joml.Vector3d;

/**
 * A place at a moment, in one frame.
 *
 * @param x to the right
 * @param y up
 * @param z into the picture
 * @param time with c = 1, in the same unit as the lengths
 */
public record Event(double x, double y, double z, double time) {

    /** The origin of a frame at time 0. */
    public static final Event ORIGIN = new Event(0, 0, 0, 0);

    /** The place. */
    public Vector3d position() {
        return new Vector3d(x, y, z);
    }

    /** This event, moved by another. */
    public Event plus(Event other) {
        return new Event(x + other.x, y + other.y, z + other.z, time + other.time);
    }

    /** The difference to another event. */
    public Event minus(Event other) {
        return new Event(x - other.x, y - other.y, z - other.z, time - other.time);
    }
}
