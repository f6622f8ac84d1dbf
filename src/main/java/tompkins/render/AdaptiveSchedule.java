package tompkins.render;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Map;
import java.util.Queue;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import tompkins.trace.Cancellation;

/**
 * Takes samples where they are needed. It begins with the centre of each pixel, and then takes {@link #FIRST_SAMPLES}
 * of every 17th, to find what no centre meets. If the centres say nothing about the error, it begins with that many
 * everywhere. Then, round by round, it doubles the samples of those pixels where one more sample lowers the error of
 * the picture most. Once all that was seen is good enough, it goes on where the samples may have missed light. The
 * choice depends on the picture alone, so that the result does not depend on the number of threads.
 */
final class AdaptiveSchedule implements Schedule {

    /**
     * Fewer samples miss small objects and then count the pixel as settled. With this many, the error of photographs is
     * what was promised (see the chart of antialiasing, "error found against error promised", in
     * docs/speed-and-accuracy.md).
     */
    static final int FIRST_SAMPLES = 16;

    /** A smaller picture than this, in pixels, gets as many first samples: those of its pixels tell of each other. */
    private static final int SMALLEST = 64;

    /**
     * One of this many pixels is looked at: a prime, so that all rows, columns and diagonals have such pixels. What is
     * found in one pixel leads to its neighbours.
     */
    private static final int LOOK_PERIOD = 17;

    /** The pixels that are looked at move by this many columns from row to row, so that they do not form columns. */
    private static final int LOOK_STEP = 5;

    /** No pixel gets more samples, however wrong it still is. */
    static final int MOST_SAMPLES = 1 << 16;

    /** Rounds aim lower than the target: true errors of small pictures scatter by as much around the estimate. */
    private static final double AIM = 0.9;

    private final Queue<Pass> waiting = new ArrayDeque<>();
    private final Film film;
    private final double targetError;
    private final int firstSamples;
    private final TimeBudget time;
    private boolean hasLooked;
    private boolean expectsUnseen;
    private double work;
    private volatile double expectedWork;
    private final AtomicInteger passesBegun = new AtomicInteger();

    /**
     * A schedule for one picture.
     *
     * @param film what gets the samples
     * @param severalFirst whether one sample per pixel says nothing about the error
     * @param coarseFirst whether the first pass is taken coarse to fine
     * @param targetError root mean square error of the exposed picture, or 0
     * @param time when to stop at the latest
     */
    AdaptiveSchedule(Film film, boolean severalFirst, boolean coarseFirst, double targetError, TimeBudget time) {
        this(film, FIRST_SAMPLES, severalFirst, coarseFirst, targetError, time);
    }

    /** As above, but a pixel that is looked at gets another number of samples first, a power of two. */
    AdaptiveSchedule(
            Film film, int first, boolean severalFirst, boolean coarseFirst, double targetError, TimeBudget time) {
        this.film = film;
        this.targetError = targetError;
        this.time = time;
        hasLooked = severalFirst;
        expectsUnseen = targetError == 0;
        firstSamples = first * Math.max(1, Integer.highestOneBit(SMALLEST / film.pixels()));
        // a single sample as wide as its pixel would blur what it does not resolve, and the pixel would pass for
        // settled
        waiting.addAll(Pass.of(severalFirst ? firstSamples : 1, firstSamples, coarseFirst));
        expectedWork = 2 * waiting.stream().mapToDouble(Pass::work).sum();
    }

    @Override
    public Pass next(BooleanSupplier stopped) {
        if (waiting.isEmpty() && !time.isOver()) {
            if (hasLooked) {
                plan(stopped);
            } else {
                look(stopped);
            }
        }
        Pass pass = waiting.poll();
        work += pass == null ? 0 : pass.work();
        passesBegun.incrementAndGet();
        return pass;
    }

    /** At the borders of the picture a centre has no neighbours outside, which could show an edge between them. */
    private void look(BooleanSupplier stopped) {
        hasLooked = true;
        BitSet looked = new BitSet(film.pixels());
        for (int row = 0; row < film.height(); row++) {
            Cancellation.stopIf(stopped);
            for (int column = 0; column < film.width(); column++) {
                int pixel = film.pixel(column, row);
                boolean isBorder = row == 0 || column == 0 || row == film.height() - 1 || column == film.width() - 1;
                boolean isLookedAt = isBorder || (column + LOOK_STEP * row) % LOOK_PERIOD == 0;
                if (isLookedAt && film.samples(pixel) == 1) {
                    film.restart(pixel);
                    looked.set(pixel);
                }
            }
        }
        waiting.add(Pass.refining(0, firstSamples, looked, film.sampledPixels()));
    }

    private void plan(BooleanSupplier stopped) {
        PixelVariance roughness = new PixelVariance(film, stopped);
        // only at the end: by then lines and edges have been followed, and what still stands alone does
        expectsUnseen |= roughness.rootMeanSquare() <= targetError;
        if (expectsUnseen) {
            IsolatedHighlights specks = new IsolatedHighlights(film, roughness, stopped);
            BitSet untested = specks.untested();
            if (!untested.isEmpty()) {
                untested.stream().forEach(film::restart);
                waiting.add(Pass.refining(0, firstSamples, untested, film.sampledPixels()));
                return;
            }
            roughness.expect(specks);
        }
        if (roughness.rootMeanSquare() <= targetError) {
            return;
        }
        Allocation allocation = new Allocation(film, roughness, stopped);
        int threshold = targetError > 0
                ? allocation.thresholdForVariance(roughness.sampled() * AIM * AIM * targetError * targetError)
                : allocation.thresholdForSamples(work * roughness.sampled() * (1 + time.left() / time.spent()));
        expectedWork = Math.max(work, allocation.samples(threshold) / roughness.sampled());
        Map<Integer, BitSet> chosen = new TreeMap<>();
        for (int pixel = 0; pixel < film.pixels(); pixel++) {
            if (allocation.level(pixel) >= threshold) {
                int samples = film.samples(pixel);
                if (samples == 1) {
                    film.restart(pixel);
                }
                chosen.computeIfAbsent(samples, count -> new BitSet(film.pixels()))
                        .set(pixel);
            }
        }
        chosen.forEach((samples, mask) -> {
            if (samples == 1) {
                waiting.add(Pass.refining(0, firstSamples, mask, roughness.sampled()));
            } else {
                waiting.add(Pass.refining(samples, samples, mask, roughness.sampled()));
            }
        });
    }

    @Override
    public double wantedError() {
        return targetError;
    }

    @Override
    public double progress(double done) {
        return time.isLimited() ? time.spent() / (time.spent() + time.left()) : done / expectedWork;
    }

    /** The first pass is always completed, however short the time, so that there is something to show. */
    @Override
    public boolean isOver() {
        return passesBegun.get() > 1 && time.isOver();
    }
}
