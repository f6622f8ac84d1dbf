package tompkins.render;

import java.util.stream.IntStream;
import tompkins.image.FramePicture;
import tompkins.image.LevelTable;
import tompkins.image.ToneCurve;

/**
 * A picture that is seen for a moment: it keeps the levels of one sample of a pixel at most. That is a quarter of the
 * memory of a {@link Film}, which takes more time to fetch than the work on it.
 */
final class PreviewFilm extends PixelBuffer {

    /** Marks a pixel that has a sample. */
    private static final int SAMPLED = 1 << 24;

    /** One level of red, of green and of blue. */
    private static final int ONE_LEVEL = 0x010101;

    /** Where half a level of one colour would get into the next. */
    private static final int HALF_LEVELS = 0x808080;

    private final LevelTable table;
    private final int[] levels;

    /** A picture whose light gets its levels by a tone curve. */
    PreviewFilm(int width, int height, double exposure, ToneCurve curve) {
        super(width, height, exposure);
        table = LevelTable.of(curve);
        levels = new int[width * height];
    }

    @Override
    void add(int pixel, double red, double green, double blue, double squared, int added) {
        levels[pixel] = SAMPLED | table.levels(exposed(red), exposed(green), exposed(blue));
    }

    /** Rounded as a {@link Film} does it. */
    private float exposed(double light) {
        return (float) (exposure() * (float) light);
    }

    @Override
    int samples(int pixel) {
        return levels[pixel] / SAMPLED;
    }

    /**
     * The largest difference between the levels of four pixels in one channel, from 0 to 255. Pixels without samples do
     * not count, so that a line which leaves a cell through its side is found in the next one, too.
     */
    int contrast(int first, int second, int third, int fourth) {
        int a = levels[first];
        int b = levels[second];
        int c = levels[third];
        int d = levels[fourth];
        int known = a != 0 ? a : b != 0 ? b : c != 0 ? c : d;
        a = a != 0 ? a : known;
        b = b != 0 ? b : known;
        c = c != 0 ? c : known;
        d = d != 0 ? d : known;
        if (a == b && b == c && c == d) {
            return 0;
        }
        return Math.max(contrast(a, b, c, d, 0), Math.max(contrast(a, b, c, d, 8), contrast(a, b, c, d, 16)));
    }

    private static int contrast(int a, int b, int c, int d, int shift) {
        int ofA = a >> shift & 0xff;
        int ofB = b >> shift & 0xff;
        int ofC = c >> shift & 0xff;
        int ofD = d >> shift & 0xff;
        return Math.max(Math.max(ofA, ofB), Math.max(ofC, ofD)) - Math.min(Math.min(ofA, ofB), Math.min(ofC, ofD));
    }

    /** The picture as the screen shows it. */
    FramePicture levels() {
        return FramePicture.of(width(), height(), filled());
    }

    /** Interpolated as in a {@link Film}, but between levels instead of light, which looks the same. */
    private int[] filled() {
        int side = Math.max(1, completeStride() % Tile.SIZE);
        int[] filled = new int[levels.length];
        int bands = (height() + side - 1) / side;
        IntStream.range(0, bands).parallel().forEach(band -> {
            copyRow(band * side, filled);
            fillRow(band * side, side / 2, filled);
        });
        IntStream.range(0, bands).parallel().forEach(band -> {
            int end = Math.min((band + 1) * side, height());
            for (int step = side / 2; step > 0; step /= 2) {
                for (int row = band * side + step; row < end; row += 2 * step) {
                    copyRow(row, filled);
                    fillFromRows(row, step, filled);
                    fillRow(row, step / 2, filled);
                }
            }
        });
        return filled;
    }

    private void copyRow(int row, int[] filled) {
        for (int pixel = pixel(0, row); pixel < pixel(0, row + 1); pixel++) {
            filled[pixel] = levels[pixel] & ~SAMPLED;
        }
    }

    /** Fills what is missing in a row, at each multiple of a distance, from the rows at that distance. */
    private void fillFromRows(int row, int distance, int[] filled) {
        int above = -distance * width();
        int below = row + distance < height() ? -above : above;
        for (int pixel = pixel(0, row); pixel < pixel(0, row + 1); pixel += distance) {
            if (levels[pixel] == 0) {
                // rounded up here and down in rows, so that the picture gets neither brighter nor darker
                filled[pixel] = mean(filled[pixel + above], filled[pixel + below], ONE_LEVEL);
            }
        }
    }

    /** Fills what is missing in a row between pixels at twice a distance, and then between nearer ones. */
    private void fillRow(int row, int distance, int[] filled) {
        for (int step = distance; step > 0; step /= 2) {
            for (int column = step; column < width(); column += 2 * step) {
                int pixel = pixel(column, row);
                if (levels[pixel] == 0) {
                    int left = pixel - step;
                    filled[pixel] = mean(filled[left], filled[column + step < width() ? pixel + step : left], 0);
                }
            }
        }
    }

    /** The means of all three levels at once. */
    private static int mean(int first, int second, int roundingUp) {
        int different = first ^ second;
        return (first & second) + (different >>> 1 & ~HALF_LEVELS) + (different & roundingUp);
    }
}
