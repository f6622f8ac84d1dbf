package tompkins.trace;

import java.util.Arrays;
import tompkins.ray.Colour;
import tompkins.ray.Padded;
import tompkins.ray.RayPacket;

/**
 * One sample of each of some pixels of a block, as arrays of numbers, which short loops add up. One for each thread,
 * filled again and again.
 */
public final class BlockSamples extends Padded {

    /** The light of each sample, before exposure. */
    public final double[] red = new double[RayPacket.MOST];

    public final double[] green = new double[RayPacket.MOST];
    public final double[] blue = new double[RayPacket.MOST];

    private final int[] columns = new int[RayPacket.MOST];
    private final int[] rows = new int[RayPacket.MOST];
    private int pixels;
    private int count;

    /** Number of samples: those of the first pixels, if the block was cut short. */
    public int count() {
        return count;
    }

    /** Number of pixels of the block of which samples are wanted. */
    public int pixels() {
        return pixels;
    }

    /** Whether all of them have a sample. */
    public boolean isWhole() {
        return count == pixels;
    }

    /** The column of the pixel of a sample. */
    public int column(int sample) {
        return columns[sample];
    }

    /** The row of the pixel of a sample. */
    public int row(int sample) {
        return rows[sample];
    }

    /** The light of a sample, before exposure. */
    public Colour colour(int sample) {
        return new Colour(red[sample], green[sample], blue[sample]);
    }

    void clear() {
        pixels = 0;
    }

    void add(int column, int row) {
        columns[pixels] = column;
        rows[pixels] = row;
        pixels++;
    }

    /** Says how many of the first samples are known. */
    void setCount(int known) {
        count = known;
    }

    void set(int sample, Colour colour) {
        red[sample] = colour.red();
        green[sample] = colour.green();
        blue[sample] = colour.blue();
    }

    /** Gives the samples from one (included) to another (excluded) the same light. */
    void fill(int from, int to, Colour colour) {
        Arrays.fill(red, from, to, colour.red());
        Arrays.fill(green, from, to, colour.green());
        Arrays.fill(blue, from, to, colour.blue());
    }
}
