package tompkins.render;

/** What the parts of a picture cost that were taken so far, and so what all of it will. */
final class PartCosts {

    private double pixels;
    private double samples;
    private double expectedSamples;
    private double tracing;
    private double planning;
    private double rate;

    /**
     * Adds a part.
     *
     * @param partPixels pixels of the part
     * @param partSamples samples that were taken
     * @param progress the share of its samples that were taken, up to 1
     * @param seconds how long it took
     * @param planningSeconds how much of this was spent between the passes, which takes as long for all of the picture
     */
    void add(double partPixels, double partSamples, double progress, double seconds, double planningSeconds) {
        pixels += partPixels;
        samples += partSamples;
        expectedSamples += partSamples / progress;
        tracing += seconds - planningSeconds;
        planning = planningSeconds;
        rate = Math.max(rate, partSamples / (seconds - planningSeconds));
    }

    /** Samples that a pixel will need. */
    double samplesPerPixel() {
        return expectedSamples / pixels;
    }

    /**
     * Samples that are taken in a second, with the speed of the fastest part: the machine gets faster while the program runs
     * warm.
     */
    double rate() {
        return rate;
    }

    /** Seconds for all of a picture: as long as these parts took, and what is left at the speed of the fastest. */
    double seconds(double allSamples) {
        return planning + tracing + Math.max(0, allSamples - samples) / rate;
    }
}
