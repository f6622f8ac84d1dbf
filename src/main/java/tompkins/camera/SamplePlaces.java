package tompkins.camera;

/** Where the samples of a block lie, in the picture and on the lens. One for each thread, filled again for each block. */
public final class SamplePlaces {

    final double[] x;
    final double[] y;
    final double[] lensX;
    final double[] lensY;
    private int count;

    /** Without places, with room for {@code most}. */
    public SamplePlaces(int most) {
        x = new double[most];
        y = new double[most];
        lensX = new double[most];
        lensY = new double[most];
    }

    /** A single place, as {@link #add}. */
    static SamplePlaces single(double pictureX, double pictureY, double pupilX, double pupilY) {
        SamplePlaces single = new SamplePlaces(1);
        single.add(pictureX, pictureY, pupilX, pupilY);
        return single;
    }

    /** Number of places. */
    public int count() {
        return count;
    }

    /** Forgets all places. */
    public void clear() {
        count = 0;
    }

    /**
     * Adds a place.
     *
     * @param pictureX place in the picture in pixels, from 0 at the left edge; pixel centres lie at halves
     * @param pictureY place in the picture in pixels, from 0 at the upper edge
     * @param pupilX place on the lens in units of its radius, to the right; a point of the unit disc
     * @param pupilY place on the lens in units of its radius, up
     */
    public void add(double pictureX, double pictureY, double pupilX, double pupilY) {
        x[count] = pictureX;
        y[count] = pictureY;
        lensX[count] = pupilX;
        lensY[count] = pupilY;
        count++;
    }
}
