package tompkins.trace;

/** The two frames of a photograph. */
public enum Frame {
    /** At rest with the camera. */
    CAMERA,
    /** At rest with the scene. */
    SCENE
}
