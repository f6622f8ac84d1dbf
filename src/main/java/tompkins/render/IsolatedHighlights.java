package tompkins.render;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tompkins.trace.Cancellation;

/**
 * Specks: small spots of light, or of darkness, that stand alone, such as stars, far lamps, glints. Most samples miss
 * them. Along an edge or a line a pixel says something about the next one. A speck says nothing about where the next
 * one is, only how many there are likely to be: where some were found, others were missed.
 *
 * <p>They are counted in regions. Each region relies on the wider one around it until it holds enough specks of its
 * own. What the specks of a region cover of their pixels says how many samples it takes to find such specks: one that
 * covers the fraction c of its pixel is missed by n samples with the probability exp(-c n).
 */
final class IsolatedHighlights {

    /** What covers more of its pixel is found by a few samples. */
    private static final double LARGEST = 0.25;

    /** A pixel with more than this fraction of the variance of another shows something of the same kind. */
    private static final double SIMILAR = 0.05;

    /** Width and height of the smallest regions in pixels. */
    static final int SIDE = 8;

    /** Width in pixels of what is around the picture in {@link #variances}. */
    private static final int BORDER = 2;

    /** With this many specks of its own, a region gives them the weight of all that it takes from the wider one. */
    private static final double ENOUGH = 4;

    /**
     * Specks count as found, each in its pixel, once it is likely that as many as this are all found. Until then they
     * count alike in all pixels of a region, which get the same samples. If only pixels with a speck that was found by
     * luck got more, its light would be corrected, and that of the missed ones never found.
     */
    private static final int ALL_OF = 32;

    private final Film film;
    private final PixelVariance pixels;
    private final BitSet found;
    private final BitSet untested;

    /**
     * The variance of the samples of each pixel, in a picture with a border of two pixels: 0 where a single sample
     * tells nothing, infinite where there are none.
     */
    private final float[] variances;

    /** From the upper left pixel of a square of two by two to the twelve around the square. */
    private final int[] rim;

    /**
     * Half of the pixels are in each count, and each pixel asks the one without it: whether a speck was found in it
     * must not decide whether it gets more samples.
     */
    private final List<Regions> counts;

    /**
     * The specks of a picture.
     *
     * @param pixels tells how pixels stand out
     * @param stopped whether they are no longer wanted
     * @throws java.util.concurrent.CancellationException if they are not
     */
    IsolatedHighlights(Film film, PixelVariance pixels, BooleanSupplier stopped) {
        this.film = film;
        this.pixels = pixels;
        found = new BitSet(film.width() * film.height());
        untested = new BitSet(film.width() * film.height());
        variances = variances(film);
        int down = film.width() + 2 * BORDER;
        rim = IntStream.of(-1, 0, 1, 2)
                .flatMap(i -> IntStream.of(i - down, i + 2 * down, i * down - 1, i * down + 2))
                .distinct()
                .toArray();
        counts = Stream.generate(() -> Regions.of((film.width() + SIDE - 1) / SIDE, (film.height() + SIDE - 1) / SIDE))
                .limit(2)
                .toList();
        Tally all = new Tally();
        for (int row = 0; row < film.height(); row++) {
            Cancellation.stopIf(stopped);
            for (int column = 0; column < film.width(); column++) {
                if (mayHold(column, row) && isTested(column, row)) {
                    found.set(film.pixel(column, row));
                    all.count(variance(column, row), pixels.contrast(column, row));
                }
            }
        }
        if (!found.isEmpty()) {
            double usual = all.usualVariance();
            IntStream.range(0, counts.get(0).rows()).parallel().forEach(regions -> {
                Cancellation.stopIf(stopped);
                for (int row = regions * SIDE; row < Math.min(film.height(), (regions + 1) * SIDE); row++) {
                    for (int column = 0; column < film.width(); column++) {
                        count(column, row, usual);
                    }
                }
            });
        }
        counts.forEach(Regions::lean);
    }

    /** Whether a pixel has a variance that its mean hardly shows, and nothing around it is of the same kind. */
    private boolean mayHold(int column, int row) {
        double variance = variance(column, row);
        return variance > 0
                && film.samples(film.pixel(column, row)) > 1
                && isAlone(column, row, variance)
                && pixels.contrast(column, row) < LARGEST * variance;
    }

    private static float[] variances(Film film) {
        float[] variances = new float[(film.width() + 2 * BORDER) * (film.height() + 2 * BORDER)];
        Arrays.fill(variances, Float.POSITIVE_INFINITY);
        IntStream.range(0, film.height()).parallel().forEach(row -> {
            int index = (row + BORDER) * (film.width() + 2 * BORDER) + BORDER;
            for (int pixel = film.pixel(0, row); pixel < film.pixel(0, row + 1); pixel++, index++) {
                int samples = film.samples(pixel);
                if (samples > 0) {
                    variances[index] = samples == 1 ? 0 : (float) Math.min(Float.MAX_VALUE, film.sampleVariance(pixel));
                }
            }
        });
        return variances;
    }

    private double variance(int column, int row) {
        return variances[bordered(column, row)];
    }

    private int bordered(int column, int row) {
        return (row + BORDER) * (film.width() + 2 * BORDER) + column + BORDER;
    }

    /** Whether all neighbours have several samples. */
    private boolean isTested(int column, int row) {
        boolean tested = true;
        for (int y = row - 1; y <= row + 1; y++) {
            for (int x = column - 1; x <= column + 1; x++) {
                if (film.samples(film.pixel(x, y)) == 1) {
                    untested.set(film.pixel(x, y));
                    tested = false;
                }
            }
        }
        return tested;
    }

    /** Counts a pixel if a speck would stand alone there, and the speck in it. */
    private void count(int column, int row, double usualVariance) {
        int pixel = film.pixel(column, row);
        Tally region = region(half(column, row), column, row);
        if (film.samples(pixel) > 1 && isAlone(column, row, usualVariance)) {
            region.pixels++;
        }
        if (found.get(pixel)) {
            region.count(variance(column, row), pixels.contrast(column, row));
        }
    }

    /**
     * Whether there is a square of two by two pixels with a given one in it, as a speck on a border between pixels
     * takes, and none of the twelve pixels around the square is similar.
     */
    private boolean isAlone(int column, int row, double variance) {
        int index = bordered(column, row);
        int above = bordered(column, row - 1);
        double most = SIMILAR * variance;
        return isQuietAround(above - 1, most)
                || isQuietAround(above, most)
                || isQuietAround(index - 1, most)
                || isQuietAround(index, most);
    }

    private boolean isQuietAround(int square, double mostVariance) {
        for (int offset : rim) {
            if (variances[square + offset] > mostVariance) {
                return false;
            }
        }
        return true;
    }

    /**
     * The count of a pixel. Squares of two pixels each way belong together, so that what lies across a border between
     * pixels is more often in one count; they follow each other without a short period.
     */
    private static int half(int column, int row) {
        return (column / 2 * 0x9e3779b1 + row / 2 * 0x85ebca77) >>> 31;
    }

    private Tally region(int half, int column, int row) {
        Regions regions = counts.get(half);
        return regions.tallies.get(row / SIDE * regions.columns + column / SIDE);
    }

    /** The specks that say how many a pixel may have: those in the other half of the pixels around it. */
    private Tally telling(int column, int row) {
        return region(1 - half(column, row), column, row);
    }

    /**
     * The pixels with one sample beside those that seem to hold specks: more samples of them show whether these are the
     * ends of something longer.
     */
    BitSet untested() {
        return untested;
    }

    /** Whether none was found. */
    boolean isEmpty() {
        return found.isEmpty();
    }

    /** The pixels in which one was found. */
    IntStream found() {
        return found.stream();
    }

    /**
     * The variance of the mean of a pixel in which a speck was found. The first and the second half of its samples may
     * have met the speck equally often by chance; this number comes from all of them.
     */
    double varianceOfMean(int column, int row) {
        double coverage = pixels.contrast(column, row) / variance(column, row);
        return ofMean(variance(column, row), coverage, film.samples(film.pixel(column, row)));
    }

    /** The probability that some of the specks around a pixel would be missed by as many samples as it has. */
    double missed(int column, int row) {
        return telling(column, row).missed(film.samples(film.pixel(column, row)));
    }

    /** The variance of the mean of a pixel by specks that may have been missed. */
    double unseen(int column, int row) {
        return telling(column, row).unseen(film.samples(film.pixel(column, row)));
    }

    /** As samples are spread evenly, the variance of their mean falls faster once several of them meet each speck. */
    private static double ofMean(double ofSample, double coverage, int samples) {
        return ofSample / (samples * (1 + Math.sqrt(samples * coverage)));
    }

    /** Regions of equal size, row by row. */
    private record Regions(int columns, List<Tally> tallies) {

        static Regions of(int columns, int rows) {
            return new Regions(
                    columns,
                    Stream.generate(Tally::new).limit((long) columns * rows).toList());
        }

        int rows() {
            return tallies.size() / columns;
        }

        /** Lets each region lean on the one around it, which is twice as wide and high, from the whole picture down. */
        void lean() {
            if (tallies.size() == 1) {
                return;
            }
            Regions wider = of((columns + 1) / 2, (rows() + 1) / 2);
            for (int i = 0; i < tallies.size(); i++) {
                around(i, wider).add(tallies.get(i), 1);
            }
            wider.lean();
            for (int i = 0; i < tallies.size(); i++) {
                Tally around = around(i, wider);
                if (around.variance > 0) {
                    tallies.get(i).add(around, ENOUGH / around.specks());
                }
            }
        }

        private Tally around(int region, Regions wider) {
            return wider.tallies.get(region / columns / 2 * wider.columns + region % columns / 2);
        }
    }

    /** What was counted in a region. */
    private static final class Tally {

        /** Pixels in which a speck would have been counted if their samples had met it. */
        private double pixels;

        private double variance;
        private double squaredVariance;
        private double contrast;

        /** What {@link #unseen} gave last: neighbours usually have as many samples. */
        private double unseen;

        private int samplesOfUnseen;

        void count(double ofVariance, double ofContrast) {
            variance += ofVariance;
            squaredVariance += ofVariance * ofVariance;
            contrast += ofContrast;
        }

        void add(Tally other, double weight) {
            pixels += weight * other.pixels;
            variance += weight * other.variance;
            squaredVariance += weight * other.squaredVariance;
            contrast += weight * other.contrast;
        }

        /** How many equal specks tell as much. */
        double specks() {
            return variance * variance / squaredVariance;
        }

        /** The variance of a sample on average over the specks, in which strong ones count most. */
        double usualVariance() {
            return squaredVariance / variance;
        }

        /** The fraction of a pixel that a speck covers: the square of its mean over that of its light. */
        double coverage() {
            return variance > 0 ? contrast / variance : Double.POSITIVE_INFINITY;
        }

        /** The probability that some of these specks would be missed by so many samples. */
        double missed(int samples) {
            return 1 - Math.pow(1 - Math.exp(-(samples * coverage())), ALL_OF);
        }

        /** The variance of the mean of a pixel with so many samples by specks that may have been missed. */
        double unseen(int samples) {
            if (samples != samplesOfUnseen) {
                samplesOfUnseen = samples;
                unseen = missed(samples) * ofMean(variance / Math.max(1, pixels), coverage(), samples);
            }
            return unseen;
        }
    }
}
