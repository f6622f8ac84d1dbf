package tompkins.measure;

import tompkins.spacetime.Event;

/** What lies between two sightings: an angle in each frame, and, where both hit something, lengths and times. */
public record Separation(Sighting first, Sighting second) {

    /** The angle between both look directions in the camera frame, in radians; NaN if a ray is missing. */
    public double cameraAngle() {
        return Angles.between(first.cameraDirection(), second.cameraDirection());
    }

    /** The same angle in the scene frame, in radians; the difference is aberration. */
    public double sceneAngle() {
        return Angles.between(first.sceneDirection(), second.sceneDirection());
    }

    /** Whether both hit something. */
    public boolean hasHits() {
        return first.hit() != null && second.hit() != null;
    }

    /** From the first event of emission to the second, in the scene frame; null without two hits. */
    public Event inScene() {
        return hasHits() ? second.inScene().minus(first.inScene()) : null;
    }

    /** From the first event of emission to the second, in the camera frame; null without two hits. */
    public Event inCamera() {
        return hasHits() ? second.inCamera().minus(first.inCamera()) : null;
    }

    /** From the first event to the second in the frame in which both objects rest; null if they share none, or turn. */
    public Event inObject() {
        return first.sharesFrame(second) && !first.turns() && !second.turns()
                ? second.hit().rest().event().minus(first.hit().rest().event())
                : null;
    }

    /** |dr|² - dt² of a difference of events, the same in all frames of relativity. */
    public static double interval(Event difference) {
        return difference.position().lengthSquared() - difference.time() * difference.time();
    }
}
