package tompkins.camera;

import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.ray.Padded;
import tompkins.ray.RayPacket;

/**
 * The samples of a block: their pixels, and where they lie in an eye's picture, lens and exposure. One for each thread.
 */
public final class SamplePositions extends Padded {

    /** The moment in the middle of the exposure time. */
    public static final double MIDDLE = 0.5;

    /** Columns of the indices on Morton's way through a block, on which those that follow each other are neighbours. */
    private static final int[] MORTON_COLUMNS = IntStream.range(0, RayPacket.MOST)
            .map(index -> index & 1 | index >> 1 & 2 | index >> 2 & 4 | index >> 3 & 8)
            .toArray();

    /** Says which pixels of the whole picture are wanted. */
    @FunctionalInterface
    public interface PixelChoice {

        /** Whether a sample of a pixel is wanted. */
        boolean wants(int column, int row);
    }

    /** The columns of the pixels of the samples, in the picture of the eye. */
    public final int[] columns;

    /** The rows of these pixels. */
    public final int[] rows;

    /** Where the samples lie in the picture, in pixels from its left edge. */
    public final double[] x;

    /** In pixels from the upper edge. */
    public final double[] y;

    /** Where they lie on the lens, in units of its radius, to the right. */
    public final double[] lensX;

    /** Up. */
    public final double[] lensY;

    /** The part of the exposure time that has passed, from 0 to 1. */
    public final double[] moments;

    private EyeView eye;
    private int count;
    private int changes;

    /** Without positions, with room for {@code most}. */
    public SamplePositions(int most) {
        columns = new int[most];
        rows = new int[most];
        x = new double[most];
        y = new double[most];
        lensX = new double[most];
        lensY = new double[most];
        moments = new double[most];
    }

    /** Positions spread evenly over a picture, in pixels, so many in each row and column. */
    public static Stream<Vector2dc> spread(int width, int height, int side) {
        return IntStream.range(0, side * side)
                .mapToObj(i -> new Vector2d((i % side + 0.5) / side * width, (i / side + 0.5) / side * height));
    }

    /** A single position, as {@link #add}. */
    static SamplePositions single(double pictureX, double pictureY, double pupilX, double pupilY, double moment) {
        SamplePositions single = new SamplePositions(1);
        single.add(pictureX, pictureY, pupilX, pupilY, moment);
        return single;
    }

    /** Number of positions. */
    public int count() {
        return count;
    }

    /** The eye in whose picture they lie. */
    public EyeView eye() {
        return eye;
    }

    /** The column of the pixel of a sample in the whole picture. */
    public int column(int index) {
        return eye.column() + columns[index];
    }

    /** The row of that pixel. */
    public int row(int index) {
        return eye.row() + rows[index];
    }

    /** Removes all positions. */
    public void clear() {
        count = 0;
        changes++;
    }

    /** Removes all positions; those that follow are in the picture of an eye. */
    public void begin(EyeView seeing) {
        eye = seeing;
        clear();
    }

    /**
     * Adds the pixels of a block of the whole picture; a {@link Sampler} chooses the positions in them.
     *
     * @param left first column
     * @param top first row
     * @param width columns of the block
     * @param height rows of the block
     * @param stride distance between the pixels; at most {@link RayPacket#SIDE} of them each way
     * @param choice says which of them are wanted
     */
    public void addPixels(int left, int top, int width, int height, int stride, PixelChoice choice) {
        // the way goes through a square of twice the side only after the smaller one
        int side = Integer.highestOneBit(2 * ((Math.max(width, height) - 1) / stride) + 1);
        for (int index = 0; index < side * side; index++) {
            int across = stride * MORTON_COLUMNS[index];
            int down = stride * MORTON_COLUMNS[index >> 1];
            if (across < width && down < height && choice.wants(left + across, top + down)) {
                addPixel(left + across - eye.column(), top + down - eye.row());
            }
        }
    }

    /** Adds a pixel of the eye's picture; a {@link Sampler} chooses the position in it. */
    public void addPixel(int column, int row) {
        columns[count] = column;
        rows[count] = row;
        count++;
        changes++;
    }

    /** Differs from that of before if the pixels do. */
    int changes() {
        return changes;
    }

    /**
     * Adds a position.
     *
     * @param pictureX position in the picture in pixels, from 0 at the left edge; pixel centres lie at halves
     * @param pictureY position in the picture in pixels, from 0 at the upper edge
     * @param pupilX position on the lens in units of its radius, to the right; a point of the unit disc
     * @param pupilY position on the lens in units of its radius, up
     * @param moment the part of the exposure time that has passed, from 0 to 1
     */
    public void add(double pictureX, double pictureY, double pupilX, double pupilY, double moment) {
        x[count] = pictureX;
        y[count] = pictureY;
        lensX[count] = pupilX;
        lensY[count] = pupilY;
        moments[count] = moment;
        addPixel((int) pictureX, (int) pictureY);
    }

    /**
     * Adds another position than one of some samples. The rest is as there, and so is the pixel, whose line of a
     * rolling shutter it keeps.
     *
     * @param pictureX as for {@link #add}, and so is pictureY; it may lie outside the edges
     */
    public void addBeside(SamplePositions others, int index, double pictureX, double pictureY) {
        x[count] = pictureX;
        y[count] = pictureY;
        lensX[count] = others.lensX[index];
        lensY[count] = others.lensY[index];
        moments[count] = others.moments[index];
        addPixel(others.columns[index], others.rows[index]);
    }
}
