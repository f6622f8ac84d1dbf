package tompkins.ray;

/**
 * The rays of neighbouring samples, as arrays of numbers: what is done to all of them is done in short loops, which the compiler
 * turns into instructions for several rays at once. They have met nothing yet. One for each thread, filled again for each block.
 */
public final class RayBlock {

    /** Most rays of a block of the picture. */
    public static final int MOST = 256;

    /** Where the rays start. */
    public final double[] x;

    public final double[] y;
    public final double[] z;

    /** Unit vectors in which the rays are traced. */
    public final double[] dx;

    public final double[] dy;
    public final double[] dz;

    private final double[] time;
    private final double[] slowness;
    private final double[] frequency;
    private final double[] spread;
    private int count;

    /** A block without rays, with room for {@code most}. */
    public RayBlock(int most) {
        x = new double[most];
        y = new double[most];
        z = new double[most];
        dx = new double[most];
        dy = new double[most];
        dz = new double[most];
        time = new double[most];
        slowness = new double[most];
        frequency = new double[most];
        spread = new double[most];
    }

    /** Number of rays. */
    public int count() {
        return count;
    }

    /** Forgets all rays. */
    public void clear() {
        count = 0;
    }

    /** Adds a ray that has just left the camera, as {@link Ray#fromCamera}. */
    public void add(
            double startX,
            double startY,
            double startZ,
            double directionX,
            double directionY,
            double directionZ,
            double startTime,
            double openingAngle) {
        int place = count++;
        x[place] = startX;
        y[place] = startY;
        z[place] = startZ;
        dx[place] = directionX;
        dy[place] = directionY;
        dz[place] = directionZ;
        time[place] = startTime;
        slowness[place] = 1;
        frequency[place] = 1;
        spread[place] = openingAngle;
    }

    /** Puts a ray that has met nothing in the place of another. */
    public void set(int place, Ray ray) {
        x[place] = ray.x;
        y[place] = ray.y;
        z[place] = ray.z;
        dx[place] = ray.dx;
        dy[place] = ray.dy;
        dz[place] = ray.dz;
        time[place] = ray.time;
        slowness[place] = ray.slowness;
        frequency[place] = ray.frequency;
        spread[place] = ray.spread;
    }

    /** One of the rays. */
    public Ray ray(int place) {
        return copy(place, Ray.blank());
    }

    /** One of the rays, in memory that is used again. */
    public Ray copy(int place, Ray memory) {
        return memory.setUnmet(
                x[place],
                y[place],
                z[place],
                dx[place],
                dy[place],
                dz[place],
                time[place],
                slowness[place],
                frequency[place],
                spread[place]);
    }
}
