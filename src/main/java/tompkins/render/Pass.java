package tompkins.render;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import tompkins.camera.PixelSampler;

/**
 * One pass over the picture. Coarse passes take the first samples of every 8th, 4th, 2nd pixel in both directions, or
 * of one pixel in each tile, and each leaves out what the coarser ones took; later passes take further samples of all
 * pixels, or of chosen ones.
 *
 * @param stride distance between pixels, 1 for all of them
 * @param coarserStride stride of the pass before this one, or 0 if this is the first
 * @param firstSample number of the first sample
 * @param samples samples per pixel
 * @param inAll how many samples the pixel is divided among: those that it has after the pass, or is expected to have at
 *     the end
 * @param chosen the pixels that get them, one bit for each, or null for all
 * @param fraction the fraction of the rendered pixels that get them
 */
record Pass(int stride, int coarserStride, int firstSample, int samples, int inAll, long[] chosen, double fraction) {

    private static final int COARSEST = 8;

    /** So many are taken at once where nobody watches, since samples of a block share what is known of its pixels. */
    private static final int FIRST = 16;

    /** Later passes are at most this long, or an eighth of what is done, so that one can watch the picture improve. */
    private static final int LONG = 64;

    /** A tile of such a pass takes some seconds, and shows nothing until it is done. */
    private static final int LONGEST = 4096;

    /**
     * The passes that take the given number of samples of each pixel: 16, 16, 32, 64, 64, ..., and at the end an eighth
     * of those before. A pixel of each tile is the first to get its first samples, so that code that runs for the first
     * time soon meets all that is in the picture.
     *
     * @param inAll samples that pixels may have after later passes
     * @param coarseFirst whether somebody watches: the first sample is taken coarse to fine, and those after it are 1,
     *     2, 4, 8
     */
    static List<Pass> of(int samples, int inAll, boolean coarseFirst) {
        List<Pass> passes = new ArrayList<>();
        int coarser = 0;
        int done = coarseFirst ? 1 : Math.min(FIRST, samples);
        int factor = coarseFirst ? 2 : Tile.SIZE;
        for (int stride = coarseFirst ? COARSEST : Tile.SIZE; stride >= 1; stride /= factor) {
            double fraction = 1.0 / (stride * stride) - (coarser == 0 ? 0 : 1.0 / (coarser * coarser));
            passes.add(new Pass(stride, coarser, PixelSampler.firstOf(samples), done, inAll, null, fraction));
            coarser = stride;
        }
        while (done < samples) {
            int next = Math.min(Math.min(done, Math.min(LONGEST, Math.max(LONG, done / 8))), samples - done);
            passes.add(new Pass(1, 0, done, next, inAll, null, 1));
            done += next;
        }
        return passes;
    }

    /** A pass that takes further samples of some pixels. */
    static Pass refining(int firstSample, int samples, BitSet chosen, int pixels) {
        double fraction = (double) chosen.cardinality() / pixels;
        return new Pass(1, 0, firstSample, samples, firstSample + samples, chosen.toLongArray(), fraction);
    }

    /** Whether this pass takes samples of a pixel, whose number is {@code pixel}. */
    boolean takes(int column, int row, int pixel) {
        if (chosen != null) {
            return (chosenFrom(pixel) & 1) != 0;
        }
        return isOnGrid(column, row, stride) && (coarserStride == 0 || !isOnGrid(column, row, coarserStride));
    }

    private static boolean isOnGrid(int column, int row, int step) {
        return column % step == 0 && row % step == 0;
    }

    /** Whether this pass takes samples of some of the pixels from one on, at most 64 of them. */
    boolean takesAny(int pixel, int pixels) {
        return chosen == null || chosenFrom(pixel) << Long.SIZE - pixels != 0;
    }

    /** Which of the pixels from one on are chosen: a bit for each, the lowest for the first. */
    private long chosenFrom(int pixel) {
        int word = pixel / Long.SIZE;
        long bits = word < chosen.length ? chosen[word] >>> pixel : 0;
        boolean isWhole = pixel % Long.SIZE == 0 || word + 1 >= chosen.length;
        return isWhole ? bits : bits | chosen[word + 1] << -pixel;
    }

    /** Samples of this pass, divided by the number of pixels that are rendered. */
    double work() {
        return samples * fraction;
    }
}
