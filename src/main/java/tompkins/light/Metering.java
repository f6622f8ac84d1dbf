package tompkins.light;

/** How a photograph is exposed where motion changes the brightness of the scene. */
public enum Metering {
    /** White light of the scene keeps its luminance in the middle of the picture. */
    MIDDLE,
    /**
     * The light is taken as it comes, so that the brightness of an object does not depend on where the camera looks.
     */
    NONE
}
