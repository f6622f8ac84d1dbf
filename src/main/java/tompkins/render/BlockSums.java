package tompkins.render;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import tompkins.ray.Padded;
import tompkins.ray.RayPacket;
import tompkins.trace.BlockSamples;
import tompkins.trace.SampleSink;

/**
 * Adds up the samples that a pass takes of a block of pixels, in double precision, and then gives the film their sums.
 * The film has single precision, and would lose the last digits of each of many samples. One for each thread.
 */
final class BlockSums extends Padded implements SampleSink {

    private final PixelBuffer buffer;
    private final BooleanSupplier stopped;
    private final double[] red = new double[RayPacket.MOST];
    private final double[] green = new double[RayPacket.MOST];
    private final double[] blue = new double[RayPacket.MOST];
    private final double[] squares = new double[RayPacket.MOST];
    private Pass pass;

    /** What was taken last, which knows its pixels. */
    private BlockSamples last;

    /** Number of samples of each pixel. */
    private int taken;

    /** So many of the first pixels have one sample more, because the block was cut short. */
    private int more;

    /**
     * Sums for one film.
     *
     * @param stopped whether no sample is wanted any more
     */
    BlockSums(PixelBuffer buffer, BooleanSupplier stopped) {
        this.buffer = buffer;
        this.stopped = stopped;
    }

    /** Begins a block of a pass. */
    void begin(Pass ofPass) {
        pass = ofPass;
    }

    @Override
    public boolean wants(int column, int row) {
        return pass.takes(column, row, buffer.pixel(column, row));
    }

    @Override
    public boolean isStopped() {
        return stopped.getAsBoolean();
    }

    @Override
    public void take(BlockSamples samples) {
        last = samples;
        taken += samples.isWhole() ? 1 : 0;
        more = samples.isWhole() ? 0 : samples.count();
        for (int i = 0; i < samples.count(); i++) {
            red[i] += samples.red[i];
        }
        for (int i = 0; i < samples.count(); i++) {
            green[i] += samples.green[i];
        }
        for (int i = 0; i < samples.count(); i++) {
            blue[i] += samples.blue[i];
        }
        for (int i = 0; i < samples.count(); i++) {
            squares[i] += Film.squared(samples.red[i], samples.green[i], samples.blue[i]);
        }
    }

    /** Gives the film what was summed up, and starts from 0 again. */
    void addToFilm() {
        int pixels = taken == 0 ? more : last.pixels();
        for (int i = 0; i < pixels; i++) {
            int added = taken + (i < more ? 1 : 0);
            buffer.add(buffer.pixel(last.column(i), last.row(i)), red[i], green[i], blue[i], squares[i], added);
        }
        taken = 0;
        more = 0;
        Arrays.fill(red, 0);
        Arrays.fill(green, 0);
        Arrays.fill(blue, 0);
        Arrays.fill(squares, 0);
    }
}
