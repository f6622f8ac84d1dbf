package tompkins.animation;

/** How far one of several pictures is: it is being taken; is taken and saved; or was there already and is left. */
public enum PictureState {
    BEGUN,
    DONE,
    SKIPPED
}
