package tompkins.surface;

/** Whether a surface throws a shadow. */
public enum Shadow {
    /** Everywhere. */
    ALWAYS,
    /** Nowhere: light passes. */
    NEVER,
    /** At some points: {@link Surface#throwsShadowAt} must be asked. */
    BY_POINT;

    /** Whether a surface throws a shadow that is this one at some of its points, and the other one at others. */
    Shadow orElsewhere(Shadow other) {
        return this == other ? this : BY_POINT;
    }
}
