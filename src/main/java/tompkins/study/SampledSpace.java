package tompkins.study;

/** The space over which the samples of a problem are spread. */
enum SampledSpace {

    /** The lens; in the centre of the pixel and the middle of the exposure time. */
    LENS(2),

    /** The lens and the pixel. */
    LENS_AND_PIXEL(4),

    /** The exposure time and the pixel, through a pinhole. */
    TIME_AND_PIXEL(3),

    /** The lens, the exposure time and the pixel. */
    ALL(5);

    private final int dimensions;

    SampledSpace(int dimensions) {
        this.dimensions = dimensions;
    }

    int dimensions() {
        return dimensions;
    }

    boolean hasLens() {
        return this != TIME_AND_PIXEL;
    }

    boolean hasPixel() {
        return this != LENS;
    }

    boolean hasTime() {
        return this == TIME_AND_PIXEL || this == ALL;
    }
}
