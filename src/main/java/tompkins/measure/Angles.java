package tompkins.measure;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Angles between directions. */
public final class Angles {

    /** Minutes of arc in a radian. */
    public static final double ARC_MINUTES = 60 * 180 / Math.PI;

    private Angles() {}

    /** The angle between two directions of any length, in radians, with all its digits; NaN if one of them is null. */
    public static double between(Vector3dc first, Vector3dc second) {
        if (first == null || second == null) {
            return Double.NaN;
        }
        return Math.atan2(first.cross(second, new Vector3d()).length(), first.dot(second));
    }
}
