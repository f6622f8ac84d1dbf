package tompkins.measure;

import java.util.Set;

/** What can be drawn over a picture. */
public enum OverlayKind {
    /** The predicted outlines of spheres. */
    OUTLINES,
    /** The axes of rods and the edges of flat pieces, hyperbolas in the picture; and the rims of round pieces. */
    LINES,
    /** The same, and the outlines, as a camera at rest sees them from the same position at the same time. */
    AT_REST,
    /** The same, where they are by the clocks of the camera: contracted, whatever is seen. */
    MEASURED,
    /** Where objects are seen, and where they are when the picture is taken, by the clocks of the camera. */
    PLACES,
    /** Circles of equal angle to the motion in the scene frame, and meridians. */
    SCENE_GRID,
    /** Circles of equal angle to the motion in the camera frame, and meridians. */
    CAMERA_GRID,
    /** What is across the motion in the scene frame, and in the camera frame. */
    HORIZON,
    /** Doppler factors: circles for what is at rest in the scene, numbers for what moves. */
    DOPPLER,
    /** Where the first light of flashes is at the moment, on the surfaces that are seen. */
    WAVE_FRONTS,
    /** The names of objects. */
    LABELS,
    /** The names of the brightest stars. */
    STARS;

    /** Those that show the axes of rods, and edges. */
    public static final Set<OverlayKind> OF_LINES = Set.of(LINES, AT_REST, MEASURED);
}
