package tompkins.animation;

/** How far one of several pictures is. */
public enum PictureState {
    /** It is being taken. */
    BEGUN,
    /** It is taken and saved. */
    DONE,
    /** It was there already, and is left. */
    SKIPPED
}
