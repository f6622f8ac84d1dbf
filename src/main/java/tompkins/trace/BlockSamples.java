package tompkins.trace;

import java.util.Arrays;
import java.util.stream.IntStream;
import tompkins.camera.StereoLayout;
import tompkins.ray.Colour;
import tompkins.ray.Padded;
import tompkins.ray.RayPacket;

/** One sample of each of some pixels of a block, as arrays of numbers. One for each thread. */
public final class BlockSamples extends Padded {

    /** Columns of the indices on Morton's way through a block, on which those that follow each other are neighbours. */
    private static final int[] MORTON_COLUMNS = IntStream.range(0, RayPacket.MOST)
            .map(index -> index & 1 | index >> 1 & 2 | index >> 2 & 4 | index >> 3 & 8)
            .toArray();

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

    /** How many pixels an index on the way through a block is to the right of its first one. */
    static int across(int index) {
        return MORTON_COLUMNS[index];
    }

    /** How many pixels it is below. */
    static int down(int index) {
        return MORTON_COLUMNS[index >> 1];
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

    /** Lets the first samples show what both eyes see: this has that of the left one. */
    void combine(StereoLayout layout, BlockSamples right, int known) {
        for (int i = 0; i < known; i++) {
            set(i, layout.combined(colour(i), right.colour(i)));
        }
    }

    /** Gives the samples from one (included) to another (excluded) the same light. */
    void fill(int from, int to, Colour colour) {
        Arrays.fill(red, from, to, colour.red());
        Arrays.fill(green, from, to, colour.green());
        Arrays.fill(blue, from, to, colour.blue());
    }
}
