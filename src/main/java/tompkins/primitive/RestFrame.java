package tompkins.primitive;

import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;

/**
 * The frame in which an object rests and is described.
 *
 * @param motion how it moves; null if it is the outermost frame
 * @param properTimeZero where and when its coordinates are 0, in the coordinates in which the tracer works
 * @param clockOffset what its clocks show at its time 0
 * @param rotation how it turns in that frame, or null if it rests
 */
public record RestFrame(FrameMotion motion, Event properTimeZero, double clockOffset, Rotation rotation) {

    /** At rest in the outermost frame, whose coordinates are those of the tracer. */
    public static final RestFrame OUTERMOST = new RestFrame(null, Event.ORIGIN, 0, null);

    /** That of objects that turn in this frame. */
    public RestFrame turning(Rotation newRotation) {
        return new RestFrame(motion, properTimeZero, clockOffset, newRotation);
    }

    /**
     * An event in the coordinates in which the object is described; of what turns, before it turned, and its own time.
     */
    public Event own(Event event) {
        return (rotation == null ? event : rotation.described(event)).minus(properTimeZero);
    }
}
