package tompkins.spacetime;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Places as the program works them out with all digits, however far they are from the origin. */
public final class Nearby {

    private Nearby() {}

    /** The place of an event in the other frame, as seen from a place near it there. */
    public static Vector3d place(SpaceTimeTransformation transformation, Vector3dc near, Event event) {
        return transformation
                .transform(PreciseEvent.of(event))
                .minus(new Event(near.x(), near.y(), near.z(), 0))
                .rounded()
                .position();
    }
}
