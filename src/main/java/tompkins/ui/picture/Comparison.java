package tompkins.ui.picture;

/** How the canvas shows the picture and another one. */
public enum Comparison {
    /** The picture alone. */
    NONE,
    /** The picture to the left of a divider, the other one to the right. */
    SPLIT,
    /** Both, as large as the window allows: the other one to the right, or below. */
    BESIDE,
    /** By how much the two differ. */
    DIFFERENCE
}
