package tompkins.lesson;

/** What can be read from a ray and from what it meets. */
public enum RayValue {
    /** Position in the scene, along x, at which the light left what is seen. */
    X,
    /** Position in the scene, along y. */
    Y,
    /** Position in the scene, along z. */
    Z,
    /** Time of the scene at which the light left what is seen. */
    TIME,
    /** Time at which it left, by the clocks of what is seen. */
    OWN_TIME,
    /** Frequency that the camera sees, divided by the frequency with which the light is sent out. */
    FREQUENCY_RATIO,
    /** Brightness in linear light, before the exposure; white is 1. */
    BRIGHTNESS
}
