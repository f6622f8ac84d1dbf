package tompkins.image;

/** Temporary. */
public enum ToneCurve {
    LINEAR,
    SRGB
}
