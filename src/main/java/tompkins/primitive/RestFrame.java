package tompkins.primitive;

import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;

/**
 * The frame in which an object rests and is described.
 *
 * @param motion how it moves; null if it is the outermost frame
 * @param zero where and when its coordinates are 0, in the coordinates in which the tracer works
 * @param clockOffset what its clocks show at its time 0
 */
public record RestFrame(FrameMotion motion, Event zero, double clockOffset) {

    /** At rest in the outermost frame, whose coordinates are those of the tracer. */
    public static final RestFrame OUTERMOST = new RestFrame(null, Event.ORIGIN, 0);

    /** An event in the coordinates in which the object is described. */
    public Event own(Event event) {
        return event.minus(zero);
    }
}
