package tompkins.measure;

/** What can be drawn over a picture. */
public enum OverlayKind {
    /** The predicted outlines of spheres. */
    OUTLINES,
    /** The axes of rods: straight in space, hyperbolas in the picture. */
    RODS,
    /** Where objects are seen, and where they are when the picture is taken, by the clocks of the camera. */
    PLACES,
    /** Circles of equal angle to the motion in the scene frame, and meridians. */
    SCENE_GRID,
    /** Circles of equal angle to the motion in the camera frame, and meridians. */
    CAMERA_GRID,
    /** What is across the motion in the scene frame, and in the camera frame. */
    HORIZON,
    /** The names of objects. */
    LABELS
}
