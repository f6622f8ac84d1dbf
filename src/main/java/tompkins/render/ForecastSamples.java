package tompkins.render;

/** What the rendered parts of a picture have cost, and what the whole picture will therefore cost. */
final class ForecastSamples {

    private double pixels;
    private double samples;
    private double expectedSamples;
    private double tracing;
    private double planning;
    private double rate;

    /**
     * Adds a part that has ended.
     *
     * @param partPixels pixels of the part
     * @param partSamples samples that were taken; a part without any only takes time
     * @param progress the fraction of its samples that were taken, up to 1
     * @param seconds how long it took
     * @param planningSeconds how much of this was spent between the passes, which takes as long for all of the picture
     */
    void add(double partPixels, double partSamples, double progress, double seconds, double planningSeconds) {
        if (partSamples > 0) {
            pixels += partPixels;
            samples += partSamples;
            expectedSamples += partSamples / progress;
        }
        tracing += seconds - planningSeconds;
        planning = planningSeconds;
        rate = Math.max(rate, partSamples / (seconds - planningSeconds));
    }

    /** Whether no sample has been taken yet, so that there is nothing to estimate from. */
    boolean isEmpty() {
        return samples == 0;
    }

    /** Samples that a pixel will need. */
    double samplesPerPixel() {
        return expectedSamples / pixels;
    }

    /** Samples that are taken in a second, with the greatest speed so far: the program gets faster as it warms up. */
    double rate() {
        return rate;
    }

    /** Seconds for all of a picture: as long as these parts took, and what is left at the greatest speed. */
    double seconds(double allSamples) {
        return planning + tracing + Math.max(0, allSamples - samples) / rate;
    }
}
