package tompkins.surface;

/** Whether a surface throws a shadow. */
public enum Shadow {
    /** Everywhere. */
    ALWAYS,
    /** Nowhere: light passes. */
    NEVER,
    /** At some points: {@link Surface#throwsShadowAt} must be asked. */
    BY_POINT
}
