package tompkins.trace;

import java.util.Arrays;
import tompkins.camera.StereoLayout;
import tompkins.ray.Colour;
import tompkins.ray.Padded;
import tompkins.ray.RayPacket;

/** The light of one sample of each of some pixels, before exposure, as arrays of numbers. One for each thread. */
public final class BlockSamples extends Padded {

    /** The red part of the light. */
    public final double[] red = new double[RayPacket.MOST];

    public final double[] green = new double[RayPacket.MOST];
    public final double[] blue = new double[RayPacket.MOST];

    /** The light of a sample. */
    public Colour colour(int sample) {
        return new Colour(red[sample], green[sample], blue[sample]);
    }

    void set(int sample, Colour colour) {
        red[sample] = colour.red();
        green[sample] = colour.green();
        blue[sample] = colour.blue();
    }

    /** Lets the first samples show what both eyes see: this has that of the left one. */
    void combine(StereoLayout layout, BlockSamples right, int count) {
        for (int i = 0; i < count; i++) {
            set(i, layout.combined(colour(i), right.colour(i)));
        }
    }

    /** Gives the first samples the same light. */
    void fill(int count, Colour colour) {
        Arrays.fill(red, 0, count, colour.red());
        Arrays.fill(green, 0, count, colour.green());
        Arrays.fill(blue, 0, count, colour.blue());
    }
}
