package tompkins.render;

import java.util.BitSet;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleToLongFunction;
import java.util.stream.IntStream;
import tompkins.camera.PixelSampler;

/**
 * The passes of a picture that is seen for a moment: one sample at each knot of a wide net, and then of finer ones, as
 * far as the corners of their cells differ, the most different cells first. {@link PreviewFilm#levels} interpolates the
 * rest. A fifth of the pixels shows nearly everything.
 */
final class EdgeSchedule implements Schedule {

    /** The distance of the first knots, in pixels. */
    private static final int WIDEST = 8;

    /** In nets wider than this all knots are wanted: details hide between them. */
    private static final int FIRST_EDGES = 4;

    /** Levels from black to white. */
    private static final int TOP = 255;

    /** A smaller difference is not worth a sample: interpolation shows it. */
    private static final int SMALLEST = 6;

    /** New samples of a cell of which neighbours are chosen as well. */
    private static final int PER_CELL = 4;

    /** The same in the last cells, whose right and lower side are left to their neighbours. */
    private static final int PER_LAST_CELL = 3;

    private final PreviewFilm preview;
    private final DoubleToLongFunction budget;
    private final TimeBudget clock = new TimeBudget(Double.POSITIVE_INFINITY);
    private int stride = 2 * WIDEST;
    private long taken;
    private long most;

    /**
     * A schedule for one picture.
     *
     * @param preview what gets the samples
     * @param budget about how many samples there may be in all; asked once, with the number of samples in a second with
     *     which those of the widest net have been taken
     */
    EdgeSchedule(PreviewFilm preview, DoubleToLongFunction budget) {
        this.preview = preview;
        this.budget = budget;
    }

    @Override
    public Pass next(BooleanSupplier stopped) {
        int cell = stride;
        stride /= 2;
        if (stride == 0) {
            return null;
        }
        double fraction = 1.0 / (WIDEST * WIDEST);
        long[] chosen = null;
        if (stride < WIDEST) {
            most = most == 0 ? budget.applyAsLong(taken / clock.spent()) : most;
            // each finer net needs as many samples
            BitSet next = choose(cell, (most - taken) / Integer.numberOfTrailingZeros(cell));
            fraction = (double) next.cardinality() / preview.pixels();
            chosen = next.toLongArray();
        }
        taken += Math.round(fraction * preview.pixels());
        return new Pass(stride, 0, PixelSampler.CENTRE, 1, 1, chosen, fraction);
    }

    /**
     * Chooses pixels without samples in the cells whose corners differ most, about as many as wanted. Where cells
     * differ alike and not all can be chosen, those left out are spread evenly over the picture.
     */
    private BitSet choose(int side, long most) {
        int columns = (preview.width() + side - 1) / side;
        int rows = (preview.height() + side - 1) / side;
        byte[] differences = new byte[columns * rows];
        IntStream.range(0, rows).parallel().forEach(row -> {
            for (int column = 0; column < columns; column++) {
                differences[row * columns + column] = (byte) difference(side * column, side * row, side);
            }
        });
        int[] cells = new int[TOP + 1];
        for (byte difference : differences) {
            cells[difference & 0xff]++;
        }
        int smallest = side > FIRST_EDGES ? 0 : SMALLEST;
        long left = most / (side > 2 ? PER_CELL : PER_LAST_CELL);
        int least = TOP;
        for (; least > smallest && cells[least] <= left; least--) {
            left -= cells[least];
        }
        BitSet chosen = new BitSet(preview.pixels());
        // between the knots of the last cells the next one's left and upper side are its own
        int reach = side > 2 ? side : 1;
        long due = 0;
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int difference = differences[row * columns + column] & 0xff;
                boolean isChosen = difference > least;
                if (difference == least) {
                    due += Math.min(left, cells[least]);
                    isChosen = due >= cells[least];
                    due -= isChosen ? cells[least] : 0;
                }
                if (isChosen) {
                    choose(side * column, side * row, reach, side / 2, chosen);
                }
            }
        }
        return chosen;
    }

    private void choose(int left, int top, int reach, int step, BitSet chosen) {
        for (int row = top; row <= Math.min(top + reach, preview.height() - 1); row += step) {
            for (int column = left; column <= Math.min(left + reach, preview.width() - 1); column += step) {
                int pixel = preview.pixel(column, row);
                if (preview.samples(pixel) == 0) {
                    chosen.set(pixel);
                }
            }
        }
    }

    /** The largest difference between those corners of a cell that are known, in one channel. */
    private int difference(int left, int top, int side) {
        int right = left + side < preview.width() ? left + side : left;
        int bottom = top + side < preview.height() ? top + side : top;
        return preview.contrast(
                preview.pixel(left, top),
                preview.pixel(right, top),
                preview.pixel(left, bottom),
                preview.pixel(right, bottom));
    }

    @Override
    public double progress(double work) {
        return Math.min(1, FIRST_EDGES * work);
    }
}
