package tompkins.ray;

import java.util.ArrayList;
import java.util.List;

/**
 * A picture on ever coarser scales, each of half the width and height (L. Williams, "Pyramidal parametrics", SIGGRAPH
 * 1983), down to a single pixel. A spot is looked up on the scale whose pixels have its size, between the pixels and
 * between the scales by linear interpolation; for a long spot several such places are taken side by side.
 */
final class MipMap {

    private static final int CHANNELS = 4;

    /** The most places that are taken side by side. */
    private static final int MOST_PLACES = 16;

    private final Level[] levels;

    /** One scale: colours multiplied by their opacity, and the opacity. */
    private record Level(int width, int height, float[] rgba) {}

    /** All scales of a picture, whose colours are not multiplied by their opacity yet. */
    MipMap(int width, int height, float[] rgba, boolean opaque) {
        List<Level> all = new ArrayList<>();
        all.add(new Level(width, height, opaque ? rgba : multiplied(rgba)));
        for (Level last = all.get(0); last.width * last.height > 1; last = all.get(all.size() - 1)) {
            all.add(halved(last));
        }
        levels = all.toArray(new Level[0]);
    }

    private static float[] multiplied(float[] rgba) {
        float[] multiplied = rgba.clone();
        for (int i = 0; i < rgba.length; i++) {
            multiplied[i] *= i % CHANNELS == 3 ? 1 : rgba[i | 3];
        }
        return multiplied;
    }

    /** Each pixel is the mean of what it covers, so that no light is lost, also if a side is odd. */
    private static Level halved(Level fine) {
        int width = (fine.width + 1) / 2;
        int height = (fine.height + 1) / 2;
        float[] rgba = new float[CHANNELS * width * height];
        double[] sum = new double[CHANNELS];
        for (int y = 0, to = 0; y < height; y++) {
            double top = (double) y * fine.height / height;
            double bottom = (y + 1.0) * fine.height / height;
            for (int x = 0; x < width; x++, to += CHANNELS) {
                double left = (double) x * fine.width / width;
                double right = (x + 1.0) * fine.width / width;
                addArea(fine, left, right, top, bottom, sum);
                for (int channel = 0; channel < CHANNELS; channel++) {
                    rgba[to + channel] = (float) (sum[channel] / ((right - left) * (bottom - top)));
                    sum[channel] = 0;
                }
            }
        }
        return new Level(width, height, rgba);
    }

    private static void addArea(Level fine, double left, double right, double top, double bottom, double[] sum) {
        for (int y = (int) top; y < bottom; y++) {
            double high = Math.min(bottom, y + 1) - Math.max(top, y);
            for (int x = (int) left; x < right; x++) {
                double weight = high * (Math.min(right, x + 1) - Math.max(left, x));
                add(fine, Math.min(x, fine.width - 1), Math.min(y, fine.height - 1), weight, sum);
            }
        }
    }

    private static void add(Level level, int x, int y, double weight, double[] sum) {
        int from = CHANNELS * (y * level.width + x);
        for (int channel = 0; channel < CHANNELS; channel++) {
            sum[channel] += weight * level.rgba[from + channel];
        }
    }

    /**
     * The mean over a spot.
     *
     * @param u from 0 at the left edge to 1 at the right one
     * @param v from 0 at the lower edge to 1 at the upper one
     * @param halfU half the extent of the spot along u
     * @param halfV half the extent along v
     * @param isRound whether the right edge is followed by the left one; otherwise a picture ends at its edges, for
     *     spots that are smaller than it
     */
    Texel mean(double u, double v, double halfU, double halfV, boolean isRound) {
        // a spot as large as the picture, or one of no known size
        double extentU = halfU < 0.5 ? 2 * halfU : 1;
        double extentV = halfV < 0.5 ? 2 * halfV : 1;
        boolean wrapsU = isRound || extentU == 1;
        boolean wrapsV = extentV == 1;
        double pixelsU = extentU * levels[0].width;
        double pixelsV = extentV * levels[0].height;
        double longer = Math.max(pixelsU, pixelsV);
        double shorter = Math.max(1, Math.min(pixelsU, pixelsV));
        int places = (int) Math.max(1, Math.min(MOST_PLACES, Math.ceil(longer / shorter)));
        double scale = wrapsV && extentU == 1
                ? levels.length - 1
                : Math.min(levels.length - 1, log2(Math.max(shorter, longer / places)));
        double stepU = pixelsU >= pixelsV ? extentU / places : 0;
        double stepV = pixelsU >= pixelsV ? 0 : extentV / places;
        int level = (int) scale;
        double[] sum = new double[CHANNELS];
        for (int place = 0; place < places; place++) {
            double aside = place - 0.5 * (places - 1);
            double placeU = u + aside * stepU;
            double placeV = v + aside * stepV;
            double coarser = (scale - level) / places;
            addBetween(levels[level], placeU, placeV, wrapsU, wrapsV, 1.0 / places - coarser, sum);
            if (coarser > 0) {
                addBetween(levels[level + 1], placeU, placeV, wrapsU, wrapsV, coarser, sum);
            }
        }
        return new Texel(new Colour(sum[0], sum[1], sum[2]), sum[3]);
    }

    private static double log2(double number) {
        return Math.log(number) / Math.log(2);
    }

    /** Adds what lies between the four pixels around a place. */
    private static void addBetween(
            Level level, double u, double v, boolean wrapsU, boolean wrapsV, double weight, double[] sum) {
        double x = u * level.width - 0.5;
        double y = (1 - v) * level.height - 0.5;
        double left = Math.floor(x);
        double top = Math.floor(y);
        int x0 = inside(left, level.width, wrapsU);
        int x1 = inside(left + 1, level.width, wrapsU);
        int y0 = inside(top, level.height, wrapsV);
        int y1 = inside(top + 1, level.height, wrapsV);
        double right = x - left;
        double bottom = y - top;
        add(level, x0, y0, weight * (1 - right) * (1 - bottom), sum);
        add(level, x1, y0, weight * right * (1 - bottom), sum);
        add(level, x0, y1, weight * (1 - right) * bottom, sum);
        add(level, x1, y1, weight * right * bottom, sum);
    }

    private static int inside(double index, int count, boolean wraps) {
        if (wraps) {
            return (int) (index - count * Math.floor(index / count));
        }
        return (int) Math.max(0, Math.min(count - 1, index));
    }
}
