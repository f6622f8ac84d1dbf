package tompkins.render;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import tompkins.trace.Cancellation;
import tompkins.trace.RenderPlan;

/**
 * How difficult each pixel is, and so how wrong it may still be. The variance of a pixel's mean is taken to fall as
 * {@code roughness n^-POWER} with the number n of its samples; the roughness is measured where there are samples, and
 * shared with the eight neighbours: an edge that no sample of a pixel has met yet may have been met next door.
 *
 * <p>Where a pixel has several samples, its roughness is that of the difference between the first and the second half
 * of them. If it has only the one in its centre, the second differences over its neighbours give its roughness: an edge
 * of height h raises those of two pixels by h, and is wrong by h/sqrt(12) in one of them.
 *
 * <p>No neighbour tells of small lights; {@link #expect} counts those that samples may have missed.
 */
final class PixelVariance {

    /** Variance falls with this power: the mean of pixels with edges, sampled over pixel and lens. */
    static final double POWER = 1.25;

    /** So many times such a variance {@link Film#halvesVariance} is: halves fill a pixel less evenly than all. */
    private static final double OF_HALVES = Math.pow(2, POWER) - 1;

    private static final double WEIGHT_OF_SECOND_DIFFERENCE = 1.0 / 24;

    /** Rows that one thread takes at a time, so that each region of specks is asked by one thread alone. */
    private static final int BAND = IsolatedHighlights.SIDE;

    /** Counts are taken to be those of chance within this factor. */
    private static final double CHANCE = 0.5;

    private final int width;
    private final int height;
    private final Film film;

    /** The roughness that each pixel's own samples show, in a picture with a border; NaN where there are no samples. */
    private final float[] own;

    /** From a pixel to the eight around it. */
    private final int[] around;

    private float[] shared;
    private final BooleanSupplier stopped;
    private final int sampled;
    private final Power falling = new Power(-POWER);

    /**
     * Whether one sample in each pixel says nothing about their errors: it shows no blur of a wide aperture or a long
     * exposure, its second differences are those of stars, which are no errors, and it has them only where three pixels
     * lie in a line.
     */
    static boolean needsSeveralSamples(RenderPlan plan) {
        return plan.blurs() || plan.hasStars() || Math.max(plan.width(), plan.height()) < 3;
    }

    /**
     * The root mean square error that a picture still has in linear light; NaN if there is too little to estimate it
     * from, or if it is no longer wanted.
     *
     * @param sampledPixels pixels of the film that have samples
     */
    static double estimatedError(Film film, int sampledPixels, RenderPlan plan, BooleanSupplier stopped) {
        boolean samplesMissing = film.samples(0) == 1 && needsSeveralSamples(plan);
        boolean varianceUnknown = film.samples(0) > 1 && !film.comparesSamples();
        boolean pixelsMissing = sampledPixels < film.width() * film.height();
        if (samplesMissing || varianceUnknown || pixelsMissing) {
            return Double.NaN;
        }
        try {
            PixelVariance variance = new PixelVariance(film, stopped);
            if (film.comparesSamples()) {
                variance.expect(new IsolatedHighlights(film, variance, stopped));
            }
            return variance.rootMeanSquare();
        } catch (CancellationException unwanted) {
            return Double.NaN;
        }
    }

    /** The memory of {@link #estimatedError}: own and shared, and with highlights at most three more such arrays. */
    static int bytesPerPixel(boolean comparesSamples) {
        return (comparesSamples ? 5 : 2) * Float.BYTES;
    }

    /**
     * The roughness of the pixels that have samples.
     *
     * @param stopped whether it is no longer wanted
     * @throws CancellationException if it is not
     */
    PixelVariance(Film film, BooleanSupplier stopped) {
        this.film = film;
        this.stopped = stopped;
        width = film.width();
        height = film.height();
        sampled = film.sampledPixels();
        own = new float[(width + 2) * (height + 2)];
        int down = width + 2;
        around = new int[] {-down - 1, -down, -down + 1, -1, 1, down - 1, down, down + 1};
        Arrays.fill(own, Float.NaN);
        bands().forEach(this::measureBand);
        shared = withNeighbours();
        fillGaps();
    }

    /**
     * Where all samples of a pixel and of its neighbours agree, they may have missed what others met by chance, such as
     * a short flash or a thin bar: such a pixel takes the mean of the smallest square in which this is likely.
     */
    private void fillGaps() {
        int columns = (width + IsolatedHighlights.SIDE - 1) / IsolatedHighlights.SIDE;
        int rows = (height + IsolatedHighlights.SIDE - 1) / IsolatedHighlights.SIDE;
        Square[] squares = IntStream.range(0, columns * rows)
                .parallel()
                .mapToObj(i -> new Square(i % columns * IsolatedHighlights.SIDE, i / columns * IsolatedHighlights.SIDE))
                .toArray(Square[]::new);
        fillGaps(squares, columns);
    }

    /** Fills the gaps of squares, row by row, and then those of squares that are twice as wide. */
    private void fillGaps(Square[] squares, int columns) {
        Arrays.stream(squares).parallel().filter(Square::isByChance).forEach(Square::fill);
        if (squares.length == 1) {
            return;
        }
        int wideColumns = (columns + 1) / 2;
        int rows = squares.length / columns;
        Square[] wide = new Square[wideColumns * ((rows + 1) / 2)];
        for (int i = 0; i < squares.length; i++) {
            int at = i / columns / 2 * wideColumns + i % columns / 2;
            if (wide[at] == null) {
                wide[at] = squares[i];
            } else {
                wide[at].add(squares[i]);
            }
        }
        fillGaps(wide, wideColumns);
    }

    /** Finds what each pixel's own samples, or else the differences from its neighbours, show. */
    private void measureBand(int first) {
        Power growing = new Power(POWER);
        for (int row = first; row < Math.min(height, first + BAND); row++) {
            Cancellation.stopIf(stopped);
            for (int column = 0; column < width; column++) {
                int pixel = film.pixel(column, row);
                int samples = film.samples(pixel);
                if (samples > 0) {
                    double roughness = samples > 1
                            ? film.halvesVariance(pixel) / OF_HALVES * growing.of(samples)
                            : secondDifferences(column, row) * WEIGHT_OF_SECOND_DIFFERENCE;
                    own[bordered(row, column)] = (float) Math.min(Float.MAX_VALUE, roughness);
                }
            }
        }
    }

    /** The first rows of bands that may be worked on side by side. */
    private IntStream bands() {
        return IntStream.range(0, (height + BAND - 1) / BAND).parallel().map(band -> band * BAND);
    }

    /**
     * Counts the light that samples may have missed, too: what specks add to the pixels in which they were found is
     * shared with those in which they may have been missed.
     *
     * @throws CancellationException if it is no longer wanted
     */
    void expect(IsolatedHighlights specks) {
        if (specks.isEmpty()) {
            return;
        }
        Power growing = new Power(POWER);
        specks.found().forEach(pixel -> {
            int column = pixel % width;
            int row = pixel / width;
            int index = bordered(row, column);
            double variance = specks.varianceOfMean(column, row) * growing.of(film.samples(pixel));
            own[index] = (float) (Math.max(own[index], variance) * (1 - specks.missed(column, row)));
        });
        shared = withNeighbours();
        bands().forEach(first -> addUnseen(specks, first));
    }

    private void addUnseen(IsolatedHighlights specks, int first) {
        Power growing = new Power(POWER);
        for (int row = first; row < Math.min(height, first + BAND); row++) {
            Cancellation.stopIf(stopped);
            for (int column = 0; column < width; column++) {
                int pixel = film.pixel(column, row);
                int samples = film.samples(pixel);
                if (samples > 0) {
                    shared[pixel] = (float) (shared[pixel] + specks.unseen(column, row) * growing.of(samples));
                }
            }
        }
    }

    /** The square of the height by which a pixel stands out, along the line through it on which this is largest. */
    double contrast(int column, int row) {
        return secondDifferences(column, row) / 4;
    }

    /** The index of a pixel in a picture with a border of one pixel. */
    private int bordered(int row, int column) {
        return (row + 1) * (width + 2) + column + 1;
    }

    /**
     * The largest mean square, over the channels, of the second differences along rows, columns and diagonals; 0 where
     * neighbours are missing.
     */
    private double secondDifferences(int column, int row) {
        double most = larger(0, secondDifference(column, row, 1, 0));
        most = larger(most, secondDifference(column, row, 0, 1));
        most = larger(most, secondDifference(column, row, 1, 1));
        return larger(most, secondDifference(column, row, 1, -1)) / 3;
    }

    /** The sum, over the channels, of the squares of the second difference; NaN where a neighbour is missing. */
    private double secondDifference(int column, int row, int right, int down) {
        double sum = 0;
        for (int channel = 0; channel < 3; channel++) {
            double difference = film.mean(column - right, row - down, channel)
                    + film.mean(column + right, row + down, channel)
                    - 2 * film.mean(column, row, channel);
            sum += difference * difference;
        }
        return sum;
    }

    /** The larger of two numbers; the first if the other is NaN. */
    private static double larger(double number, double other) {
        return other > number ? other : number;
    }

    private float[] withNeighbours() {
        float[] mean = new float[width * height];
        IntStream.range(0, height).parallel().forEach(row -> {
            Cancellation.stopIf(stopped);
            for (int column = 0; column < width; column++) {
                int here = bordered(row, column);
                if (!Float.isNaN(own[here])) {
                    mean[film.pixel(column, row)] = meanAround(here);
                }
            }
        });
        return mean;
    }

    /**
     * The mean of those neighbours of a pixel that have samples; of the pixel, too, if none of them shows anything. If
     * a pixel with samples that met little light were the first to stop, pictures would be too dark.
     */
    private float meanAround(int here) {
        double sum = 0;
        int others = 0;
        for (int offset : around) {
            if (own[here + offset] >= 0) {
                sum += own[here + offset];
                others++;
            }
        }
        return (float) (sum > 0 ? sum / others : own[here] / (others + 1));
    }

    /** Whether a pixel varies and no neighbour does. */
    private boolean isAlone(int here) {
        for (int offset : around) {
            if (own[here + offset] > 0) {
                return false;
            }
        }
        return own[here] > 0;
    }

    /** The roughness of a pixel, shared with its neighbours. */
    double of(int pixel) {
        return shared[pixel];
    }

    /** The variance that the mean of a pixel has. */
    double variance(int pixel) {
        int samples = film.samples(pixel);
        return samples <= 1 ? shared[pixel] : shared[pixel] * falling.of(samples);
    }

    /** Number of pixels that have samples. */
    int sampled() {
        return sampled;
    }

    /** The root mean square error of the pixels that have samples. */
    double rootMeanSquare() {
        double sum = 0;
        for (int pixel = 0; pixel < shared.length; pixel++) {
            sum += variance(pixel);
        }
        return Math.sqrt(sum / Math.max(1, sampled));
    }

    /**
     * What the pixels of a square with several samples tell of each other: the sum of their roughness, how many vary,
     * how many of these lie alone, and how many have nothing around that varies.
     */
    private final class Square {

        private final int left;
        private final int top;
        private int right;
        private int bottom;
        private double sum;
        private int several;
        private int varied;
        private int alone;
        private int gaps;

        /** The smallest square from a pixel to the right and down. */
        Square(int left, int top) {
            Cancellation.stopIf(stopped);
            this.left = left;
            this.top = top;
            right = Math.min(width, left + IsolatedHighlights.SIDE);
            bottom = Math.min(height, top + IsolatedHighlights.SIDE);
            for (int row = top; row < bottom; row++) {
                for (int column = left; column < right; column++) {
                    int pixel = film.pixel(column, row);
                    if (film.samples(pixel) > 1) {
                        int here = bordered(row, column);
                        several++;
                        sum += own[here];
                        varied += own[here] > 0 ? 1 : 0;
                        alone += isAlone(here) ? 1 : 0;
                        gaps += shared[pixel] == 0 ? 1 : 0;
                    }
                }
            }
        }

        /** Takes up a square to the right or below. */
        void add(Square other) {
            right = Math.max(right, other.right);
            bottom = Math.max(bottom, other.bottom);
            sum += other.sum;
            several += other.several;
            varied += other.varied;
            alone += other.alone;
            gaps += other.gaps;
        }

        /**
         * Whether chance explains the gaps: as many pixels that vary lie alone, and as few are gaps, as if each pixel
         * varied by itself with the same probability. Along edges neither is so.
         */
        boolean isByChance() {
            double constant = 1 - (double) varied / several;
            int others = Math.min(3, width) * Math.min(3, height) - 1;
            return 2 * several >= (bottom - top) * (right - left)
                    && alone > CHANCE * varied * Math.pow(constant, others)
                    && CHANCE * gaps < several * Math.pow(constant, others + 1);
        }

        void fill() {
            gaps = 0;
            for (int row = top; row < bottom; row++) {
                for (int pixel = film.pixel(left, row); pixel < film.pixel(right, row); pixel++) {
                    if (film.samples(pixel) > 1 && shared[pixel] == 0) {
                        shared[pixel] = (float) (sum / several);
                    }
                }
            }
        }
    }

    /** A power of numbers of samples, kept for the next pixel, which usually has as many. */
    private static final class Power {

        private final double exponent;
        private int samples = 1;
        private double power = 1;

        Power(double exponent) {
            this.exponent = exponent;
        }

        double of(int number) {
            if (number != samples) {
                samples = number;
                power = Math.pow(number, exponent);
            }
            return power;
        }
    }
}
