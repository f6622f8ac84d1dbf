package tompkins.studio;

/** Whether a picture shows what light brings to the camera, or where things are. */
public enum View {
    /** What the camera sees: a photograph. Light takes time, so that distant things are seen as they were. */
    SEEN,
    /**
     * Where things are at one time of the camera's frame, as its rulers and clocks measure it. That is not a
     * photograph: no light brings it.
     */
    MEASURED
}
