package tompkins.camera;

import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.ray.Padded;

/** The samples of a block: their pixels, and where they lie in picture, lens and exposure. One for each thread. */
public final class SamplePositions extends Padded {

    /** The moment in the middle of the exposure time. */
    public static final double MIDDLE = 0.5;

    /** The columns of the pixels of the samples. */
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

    private int count;

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

    /** Removes all positions. */
    public void clear() {
        count = 0;
    }

    /** Adds a pixel; a {@link PixelSampler} chooses the position in it. */
    public void addPixel(int column, int row) {
        columns[count] = column;
        rows[count] = row;
        count++;
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
