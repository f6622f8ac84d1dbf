package tompkins.camera;

import tompkins.ray.Colour;

/** How the pictures of two eyes are shown. */
public enum StereoLayout {

    /** One picture, from between the eyes. */
    NONE,

    /** The picture of the left eye alone. */
    LEFT_EYE,

    /** The picture of the right eye alone. */
    RIGHT_EYE,

    /** That of the left eye in the left half, that of the right eye in the right half. */
    SIDE_BY_SIDE,

    /** That of the left eye in the upper half, that of the right eye in the lower half. */
    TOP_AND_BOTTOM,

    /** For red and cyan glasses: red of the left eye, green and blue of the right eye. */
    ANAGLYPH,

    /** As the anaglyph, but without colours: the luminance of each eye. */
    GREY_ANAGLYPH;

    /** Whether each eye has a part of the picture to itself. */
    public boolean hasHalves() {
        return this == SIDE_BY_SIDE || this == TOP_AND_BOTTOM;
    }

    /** Whether each pixel shows what both eyes see. */
    public boolean isAnaglyph() {
        return this == ANAGLYPH || this == GREY_ANAGLYPH;
    }

    /** The colour of a pixel that both eyes share. */
    public Colour combined(Colour left, Colour right) {
        if (this == GREY_ANAGLYPH) {
            double cyan = right.luminance();
            return new Colour(left.luminance(), cyan, cyan);
        }
        return new Colour(left.red(), right.green(), right.blue());
    }

    /** Where the eye of a picture with one eye is: -1 to the left, 1 to the right, 0 in the middle. */
    int side() {
        return switch (this) {
            case LEFT_EYE -> -1;
            case RIGHT_EYE -> 1;
            default -> 0;
        };
    }
}
