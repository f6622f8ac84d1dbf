package tompkins.camera;

/** A way to choose positions for samples in pixels, on the lens and in the exposure time. One for each thread. */
public interface Sampler {

    /**
     * Chooses the positions of one sample of each pixel.
     *
     * @param positions the pixels, at most {@link tompkins.ray.RayPacket#MOST}; gets the positions
     * @param sample {@link PixelSampler#CENTRE}, or the number of the sample from 0 upwards
     */
    void choose(SamplePositions positions, int sample);
}
