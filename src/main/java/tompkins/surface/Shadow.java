package tompkins.surface;

/** Whether a surface throws a shadow. */
public enum Shadow {
    /** Everywhere. */
    ALWAYS,
    /** Nowhere: light passes. */
    NEVER,
    /** At some points: {@link Surface#throwsShadowAt} must be asked. */
    BY_POINT;

    /** How a surface throws shadows that behaves like this at some of its points, and like the other at the rest. */
    Shadow orElsewhere(Shadow other) {
        return this == other ? this : BY_POINT;
    }
}
