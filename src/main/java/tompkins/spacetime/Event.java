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

    /** The place. */
    public Vector3d position() {
        return new Vector3d(x, y, z);
    }
}
