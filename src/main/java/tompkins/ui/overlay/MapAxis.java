package tompkins.ui.overlay;

import org.joml.Vector3dc;

/** The axis of the scene along which a map looks. */
public enum MapAxis {
    /** From above: x to the right, z up. */
    ABOVE(0, 2),
    /** From the right side: z to the right, y up. */
    SIDE(2, 1),
    /** From behind: x to the right, y up. */
    BEHIND(0, 1);

    private static final String NAMES = "xyz";

    private final int right;
    private final int up;

    MapAxis(int right, int up) {
        this.right = right;
        this.up = up;
    }

    /** How far to the right a point of the scene lies on the map. */
    double right(Vector3dc point) {
        return point.get(right);
    }

    /** How far up it lies. */
    double up(Vector3dc point) {
        return point.get(up);
    }

    /** The names of both directions. */
    String names() {
        return NAMES.charAt(right) + " \u2192, " + NAMES.charAt(up) + " \u2191";
    }
}
