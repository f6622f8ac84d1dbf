package tompkins.camera;

/**
 * The samples of a block: their pixels, and where they lie in the picture, on the lens and in the exposure time. One
 * for each thread, filled again for each block.
 */
public final class SamplePlaces {

    /** The moment in the middle of the exposure time. */
    public static final double MIDDLE = 0.5;

    final int[] columns;
    final int[] rows;
    final double[] x;
    final double[] y;
    final double[] lensX;
    final double[] lensY;
    final double[] moments;
    private int count;

    /** Without places, with room for {@code most}. */
    public SamplePlaces(int most) {
        columns = new int[most];
        rows = new int[most];
        x = new double[most];
        y = new double[most];
        lensX = new double[most];
        lensY = new double[most];
        moments = new double[most];
    }

    /** A single place, as {@link #add}. */
    static SamplePlaces single(double pictureX, double pictureY, double pupilX, double pupilY, double moment) {
        SamplePlaces single = new SamplePlaces(1);
        single.add(pictureX, pictureY, pupilX, pupilY, moment);
        return single;
    }

    /** Number of places. */
    public int count() {
        return count;
    }

    /** Removes all places. */
    public void clear() {
        count = 0;
    }

    /** Adds a pixel; a {@link PixelSampler} chooses the place in it. */
    public void addPixel(int column, int row) {
        columns[count] = column;
        rows[count] = row;
        count++;
    }

    /**
     * Adds a place.
     *
     * @param pictureX place in the picture in pixels, from 0 at the left edge; pixel centres lie at halves
     * @param pictureY place in the picture in pixels, from 0 at the upper edge
     * @param pupilX place on the lens in units of its radius, to the right; a point of the unit disc
     * @param pupilY place on the lens in units of its radius, up
     * @param moment the part of the exposure time that has passed, from 0 to 1
     */
    public void add(double pictureX, double pictureY, double pupilX, double pupilY, double moment) {
        x[count] = pictureX;
        y[count] = pictureY;
        lensX[count] = pupilX;
        lensY[count] = pupilY;
        moments[count] = moment;
        addPixel((int) pictureX, (int) pictureY);
    }

    /** The column of the pixel of a place. */
    public int column(int place) {
        return columns[place];
    }

    /** The row of the pixel of a place. */
    public int row(int place) {
        return rows[place];
    }

    /** Where a place lies in the picture, in pixels from the left edge. */
    public double x(int place) {
        return x[place];
    }

    /** Where a place lies in the picture, in pixels from the upper edge. */
    public double y(int place) {
        return y[place];
    }

    /** Where a place lies on the lens, in units of its radius, to the right. */
    public double lensX(int place) {
        return lensX[place];
    }

    /** Where a place lies on the lens, in units of its radius, up. */
    public double lensY(int place) {
        return lensY[place];
    }

    /** The part of the exposure time that has passed at a place's moment, from 0 to 1. */
    public double moment(int place) {
        return moments[place];
    }
}
