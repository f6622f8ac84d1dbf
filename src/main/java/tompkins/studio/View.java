package tompkins.studio;

/** Whether a picture shows what light brings to the camera, or where things are. */
public enum View {
    /** What the camera sees: a photograph. Light takes its time, so that what is far away is seen as it was. */
    SEEN,
    /**
     * Where things are at one time of the camera's frame, as its rulers and clocks measure it: no photograph, for no
     * light brings it.
     */
    MEASURED
}
