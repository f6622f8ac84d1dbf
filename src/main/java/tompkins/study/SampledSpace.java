package tompkins.study;

/**
 * The space over which the samples of a problem are spread; in the middle of what it has not.
 *
 * @param hasLens whether it has the lens, not a pinhole
 * @param hasTime whether it has the exposure time
 * @param hasPixel whether it has the pixel
 */
record SampledSpace(boolean hasLens, boolean hasTime, boolean hasPixel) {

    static final SampledSpace LENS = new SampledSpace(true, false, false);
    static final SampledSpace LENS_AND_PIXEL = new SampledSpace(true, false, true);
    static final SampledSpace TIME_AND_PIXEL = new SampledSpace(false, true, true);
    static final SampledSpace ALL = new SampledSpace(true, true, true);

    int dimensions() {
        return (hasLens ? 2 : 0) + (hasTime ? 1 : 0) + (hasPixel ? 2 : 0);
    }
}
