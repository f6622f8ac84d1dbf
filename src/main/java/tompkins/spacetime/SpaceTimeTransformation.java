package tompkins.spacetime;

import org.joml.Vector3dc;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/** A change of frame: takes the coordinates of one inertial frame and gives those of another. Linear, and immutable. */
public sealed interface SpaceTimeTransformation
        permits LorentzTransformation, GalileanTransformation, IdentityTransformation {

    /** The same event in the other frame. */
    Event transform(Event event);

    /** The same event in the other frame, with all digits. Slower than {@link #transform(Event)}. */
    PreciseEvent transform(PreciseEvent event);

    /**
     * The same light ray in the other frame, starting at the same event. Its direction is NaN if the light stands still
     * there, which is possible in a Galilean world only.
     */
    default Ray transform(Ray ray) {
        return transform(ray, Ray.blank());
    }

    /** The same, in memory that is used again; it may be the ray itself. */
    Ray transform(Ray ray, Ray memory);

    /** Takes each ray of a packet into the other frame. */
    default void transform(RayPacket rays) {
        for (int i = 0; i < rays.count(); i++) {
            rays.set(i, transform(rays.ray(i)));
        }
    }

    /**
     * The time at which a place of the first frame has the same coordinates in the other frame: the event of the
     * fixed-point surface that passes through the place. That is 0 where all places coincide at time 0.
     */
    default double fixedPointTime(Vector3dc position) {
        return 0;
    }

    /** The way back. */
    SpaceTimeTransformation inverse();
}
