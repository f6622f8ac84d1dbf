package tompkins.render;

import java.util.BitSet;
import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import tompkins.trace.Cancellation;

/**
 * Small spots of light, or of darkness, that stand alone, such as stars, far lamps, glints. Most samples miss them.
 * Along an edge or a line a pixel says something about the next one. A spot says nothing about where the next one is,
 * only how many there are likely to be: where some were found, others were missed.
 */
final class IsolatedHighlights {

    /** Width and height of the smallest squares in which they are counted, in pixels. */
    private static final int SMALLEST_SQUARE = 8;

    /** With so many of its own a square tells of itself, and not the wider one around it. */
    private static final int ENOUGH = 4;

    /** A pixel with more than this fraction of the roughness of another shows something of the same kind. */
    private static final double SIMILAR = 0.05;

    /**
     * They count as found once it is likely that as many as this are all found. If only pixels got more samples in
     * which one was found by luck, its light would be corrected, and that of the missed ones never found.
     */
    private static final int ALL_OF = 32;

    private final Film film;
    private final BooleanSupplier stopped;
    private final float[] roughness;

    /** The pixels that show one. */
    private final BitSet found;

    /** The pixels that show one, or would if their samples had met it. */
    private final BitSet tested = new BitSet();

    /** Pixels with more roughness show something of the same kind, by themselves. */
    private final double quiet;

    /** The fraction of its pixel that one covers: the square of its mean over that of its light. */
    private final double coverage;

    /**
     * Finds them.
     *
     * @param film compares samples
     * @param roughness what the samples of each pixel show
     * @param stopped whether they are no longer wanted
     * @throws java.util.concurrent.CancellationException if they are not
     */
    IsolatedHighlights(Film film, float[] roughness, BooleanSupplier stopped) {
        this.film = film;
        this.roughness = roughness;
        this.stopped = stopped;
        found = pixels(pixel -> roughness[pixel] > 0 && standsAlone(pixel, SIMILAR * roughness[pixel]));
        double sum = 0;
        double squares = 0;
        double contrast = 0;
        double variance = 0;
        for (int pixel = found.nextSetBit(0); pixel >= 0; pixel = found.nextSetBit(pixel + 1)) {
            sum += roughness[pixel];
            squares += (double) roughness[pixel] * roughness[pixel];
            contrast += film.contrast(pixel, pixel % film.width() > 1 ? pixel - 2 : pixel + 2);
            variance += film.sampleVariance(pixel);
        }
        coverage = variance > 0 ? contrast / variance : Double.POSITIVE_INFINITY;
        // strong ones count most in the mean
        quiet = SIMILAR * squares / sum;
        if (sum > 0) {
            tested.or(pixels(pixel -> standsAlone(pixel, quiet)));
            tested.or(found);
        }
    }

    private BitSet pixels(IntPredicate test) {
        BitSet pixels = new BitSet();
        for (int row = 0; row < film.height(); row++) {
            Cancellation.stopIf(stopped);
            for (int pixel = film.pixel(0, row); pixel < film.pixel(0, row + 1); pixel++) {
                pixels.set(pixel, film.samples(pixel) > 1 && test.test(pixel));
            }
        }
        return pixels;
    }

    /**
     * Whether there is a square of two by two pixels with a given one in it, as a spot on a border between pixels
     * takes, and none of the pixels around the square is rougher.
     */
    private boolean standsAlone(int pixel, double most) {
        int column = pixel % film.width();
        int row = pixel / film.width();
        return isQuietAround(column, row, most)
                || isQuietAround(column - 1, row, most)
                || isQuietAround(column, row - 1, most)
                || isQuietAround(column - 1, row - 1, most);
    }

    /** Whether all pixels around a square are known to show little; beyond the edge of the picture nothing is known. */
    private boolean isQuietAround(int left, int top, double most) {
        if (left < 1 || top < 1 || left + 2 >= film.width() || top + 2 >= film.height()) {
            return false;
        }
        for (int row = top - 1; row <= top + 2; row++) {
            for (int column = left - 1; column <= left + 2; column++) {
                int pixel = film.pixel(column, row);
                boolean isAround = row < top || row > top + 1 || column < left || column > left + 1;
                boolean isQuiet = film.samples(pixel) == 1 || roughness[pixel] <= most;
                if (isAround && !isQuiet) {
                    return false;
                }
            }
        }
        return true;
    }

    /**
     * Lets each pixel expect what it may have missed: the mean roughness of the smallest square around it in which
     * enough was found.
     *
     * @param expected the roughness that each pixel is expected to have; it grows
     */
    void expect(float[] expected) {
        BitSet open = (BitSet) tested.clone();
        open.set(0, tested.isEmpty() ? 0 : film.pixels());
        int whole = Math.max(film.width(), film.height());
        for (int side = Math.min(SMALLEST_SQUARE, whole); !open.isEmpty(); side = Math.min(2 * side, whole)) {
            Cancellation.stopIf(stopped);
            for (Tile square : Tile.of(film.width(), film.height(), side)) {
                expect(expected, square, side == whole ? 1 : ENOUGH, open);
            }
        }
    }

    private void expect(float[] expected, Tile square, int enough, BitSet open) {
        double sum = 0;
        int ofFound = 0;
        int ofTested = 0;
        for (int row = square.row(); row < square.row() + square.height(); row++) {
            int end = film.pixel(square.column() + square.width(), row);
            for (int pixel = film.pixel(square.column(), row); pixel < end; pixel++) {
                sum += found.get(pixel) ? roughness[pixel] : 0;
                ofFound += found.get(pixel) ? 1 : 0;
                ofTested += tested.get(pixel) ? 1 : 0;
            }
        }
        for (int row = square.row(); row < square.row() + square.height() && ofFound >= enough; row++) {
            int end = film.pixel(square.column() + square.width(), row);
            for (int pixel = open.nextSetBit(film.pixel(square.column(), row));
                    pixel >= 0 && pixel < end;
                    pixel = open.nextSetBit(pixel)) {
                if (film.samples(pixel) > 0 && roughness[pixel] <= quiet) {
                    double missed = missed(film.samples(pixel)) * sum / ofTested;
                    expected[pixel] = (float) Math.max(expected[pixel], missed);
                }
                open.clear(pixel);
            }
        }
    }

    /** The probability that some would be missed by so many samples of each: one is with exp(-c n). */
    private double missed(int samples) {
        return 1 - Math.pow(1 - Math.exp(-coverage * samples), ALL_OF);
    }
}
