package tompkins.image;

/**
 * The 8-bit levels of a tone curve without working out its powers: the same level as {@link ToneCurve#quantise} for
 * every float, by a look-up. A window that shows thirty pictures a second has no time for a million powers each.
 */
public final class LevelTable {

    private static final LevelTable LINEAR = new LevelTable(ToneCurve.LINEAR);
    private static final LevelTable SRGB = new LevelTable(ToneCurve.SRGB);

    /** Fine enough that no level lies within a cell; a power of two, so that the scaling is exact. */
    private static final int CELLS = 4096;

    private static final int TOP = 255;

    /** The smallest light of each level, and infinity after the last. */
    private final float[] threshold = new float[TOP + 2];

    /** The level at the lower end of each cell. */
    private final int[] cellLevel = new int[CELLS];

    private LevelTable(ToneCurve curve) {
        for (int level = 1; level <= TOP; level++) {
            threshold[level] = smallestLight(curve, level);
        }
        threshold[TOP + 1] = Float.POSITIVE_INFINITY;
        for (int cell = 0; cell < CELLS; cell++) {
            cellLevel[cell] = curve.quantise((double) cell / CELLS, TOP);
        }
    }

    /** The table of a curve. */
    public static LevelTable of(ToneCurve curve) {
        return switch (curve) {
            case LINEAR -> LINEAR;
            case SRGB -> SRGB;
        };
    }

    /** The levels of a pixel's light, as {@link java.awt.image.BufferedImage#TYPE_INT_RGB} has them. */
    public int levels(float red, float green, float blue) {
        return level(red) << 16 | level(green) << 8 | level(blue);
    }

    /** The level of an amount of light, from 0 to 255. */
    int level(float light) {
        if (!(light > 0)) {
            return 0;
        }
        if (light >= 1) {
            return TOP;
        }
        int level = cellLevel[(int) (light * CELLS)];
        return light >= threshold[level + 1] ? level + 1 : level;
    }

    /** Bisects the floats from 0 to 1, which have the same order as their bits. */
    private static float smallestLight(ToneCurve curve, int level) {
        int below = Float.floatToIntBits(0f);
        int reaches = Float.floatToIntBits(1f);
        while (reaches - below > 1) {
            int middle = (below + reaches) >>> 1;
            if (curve.quantise(Float.intBitsToFloat(middle), TOP) >= level) {
                reaches = middle;
            } else {
                below = middle;
            }
        }
        return Float.intBitsToFloat(reaches);
    }
}
