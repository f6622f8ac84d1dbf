package tompkins.render;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import tompkins.ray.Colour;
import tompkins.ray.RayPacket;
import tompkins.trace.SampleSink;

/**
 * Adds up the samples that a pass takes of a block of pixels, in double precision, and then gives the film their sums.
 * The film has single precision, and would lose the last digits of each of many samples. The film gets single samples
 * directly, because coarse passes take no more. One for each thread.
 */
final class BlockSums implements SampleSink {

    private final Film film;
    private final BooleanSupplier stopped;
    private final double[] sums = new double[3 * RayPacket.MOST];
    private final double[] squares = new double[RayPacket.MOST];
    private final int[] counts = new int[RayPacket.MOST];
    private Pass pass;
    private int left;
    private int top;

    /**
     * Sums for one film.
     *
     * @param stopped whether no sample is wanted any more
     */
    BlockSums(Film film, BooleanSupplier stopped) {
        this.film = film;
        this.stopped = stopped;
    }

    /** Begins the block of a pass whose first pixel is given. */
    void begin(Pass ofPass, int firstColumn, int firstRow) {
        pass = ofPass;
        left = firstColumn;
        top = firstRow;
    }

    @Override
    public boolean wants(int column, int row) {
        return pass.takes(column, row, film.pixel(column, row));
    }

    @Override
    public boolean isStopped() {
        return stopped.getAsBoolean();
    }

    @Override
    public void take(int column, int row, Colour colour) {
        if (pass.samples() == 1) {
            film.add(film.pixel(column, row), colour.red(), colour.green(), colour.blue(), 1);
            return;
        }
        int place = (row - top) * RayPacket.SIDE + column - left;
        sums[3 * place] += colour.red();
        sums[3 * place + 1] += colour.green();
        sums[3 * place + 2] += colour.blue();
        squares[place] += Film.squared(colour.red(), colour.green(), colour.blue());
        counts[place]++;
    }

    /** Gives the film what was summed up, and starts from 0 again. */
    void addToFilm() {
        if (pass.samples() == 1) {
            return;
        }
        for (int place = 0; place < counts.length; place++) {
            if (counts[place] > 0) {
                int column = left + place % RayPacket.SIDE;
                int row = top + place / RayPacket.SIDE;
                film.add(
                        film.pixel(column, row),
                        sums[3 * place],
                        sums[3 * place + 1],
                        sums[3 * place + 2],
                        squares[place],
                        counts[place]);
            }
        }
        Arrays.fill(sums, 0);
        Arrays.fill(squares, 0);
        Arrays.fill(counts, 0);
    }
}
