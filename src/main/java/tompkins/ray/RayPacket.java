package tompkins.ray;

import java.util.Arrays;

/**
 * The rays of neighbouring samples, as arrays of numbers. Short loops work on all of them, which the compiler turns
 * into instructions for several rays at once. The rays start on no object. One for each thread, filled again for each
 * packet.
 */
public final class RayPacket extends Padded {

    /** Largest width and height of a block of the picture. */
    public static final int SIDE = 16;

    /** Most rays of a block of the picture. */
    public static final int MOST = SIDE * SIDE;

    /** Where the rays start. */
    public final double[] x;

    public final double[] y;
    public final double[] z;

    /** Unit vectors in which the rays are traced. */
    public final double[] dx;

    public final double[] dy;
    public final double[] dz;

    /** When the light is at the start. */
    public final double[] time;

    /** Opening angles of the bundles. */
    public final double[] spread;

    /** Time that passes per unit length. */
    public final double[] slowness;

    /** Frequencies in the frame of the rays, divided by those in the camera frame. */
    public final double[] frequency;

    /** Lengths of the directions that had length 1 when the rays left the camera. */
    public final double[] directionLength;

    /** The arrays that a camera sets; the rest is the same for all its rays. */
    private final double[][] setByCamera;

    private final double[][] numbers;

    private final double[] width;
    private final double[] windowFactor;
    private final double[] throughput;
    private final int[] depth;
    private final int[] samples;
    private int count;
    private int frame;

    /** The medium of each ray; null if none is in a medium that matters. */
    private Medium[] media;

    private boolean measures;

    /** A packet without rays, with room for {@code most}. */
    public RayPacket(int most) {
        x = new double[most];
        y = new double[most];
        z = new double[most];
        dx = new double[most];
        dy = new double[most];
        dz = new double[most];
        time = new double[most];
        slowness = new double[most];
        frequency = new double[most];
        directionLength = new double[most];
        width = new double[most];
        windowFactor = new double[most];
        throughput = new double[most];
        depth = new int[most];
        spread = new double[most];
        samples = new int[most];
        setByCamera = new double[][] {x, y, z, dx, dy, dz, time, spread};
        numbers = new double[][] {
            x, y, z, dx, dy, dz, time, spread, slowness, frequency, directionLength, width, windowFactor, throughput
        };
    }

    /** The number of the frame in which the rays are given, as in {@link Ray#frame}. */
    public int frame() {
        return frame;
    }

    /** Says in which frame the rays are given. */
    public void inFrame(int number) {
        frame = number;
    }

    /** Number of rays. */
    public int count() {
        return count;
    }

    /**
     * Begins anew with a number of rays that have just left the camera, one for each sample; the caller sets the rest.
     */
    public void begin(int newCount) {
        count = newCount;
        frame = 0;
        media = null;
        measures = false;
        for (int i = 0; i < count; i++) {
            slowness[i] = 1;
            frequency[i] = 1;
            directionLength[i] = 1;
            width[i] = 0;
            windowFactor[i] = 1;
            throughput[i] = 1;
            depth[i] = 0;
            samples[i] = i;
        }
    }

    /** Lets all rays, which have just left the camera, start in a medium with a slowness. */
    public void startIn(double mediumSlowness) {
        Arrays.fill(slowness, 0, count, mediumSlowness);
    }

    /** Lets all rays be in a medium, or in none that matters. */
    public void in(Medium medium) {
        media = medium == null ? null : new Medium[x.length];
        if (medium != null) {
            Arrays.fill(media, medium);
        }
    }

    /** Whether all rays are in one medium that matters, or none is. */
    public boolean isInOneMedium() {
        return media == null || Arrays.stream(media, 0, count).allMatch(medium -> medium == media[0]);
    }

    /** The medium of the ray at an index, as {@link Ray#medium}. */
    public Medium medium(int index) {
        return media == null ? null : media[index];
    }

    /** Makes all rays, which have just left the camera, lines of events at one time of the camera. */
    public void measure() {
        startIn(0);
        measures = true;
    }

    /** Makes this hold the same rays as another packet. */
    public void set(RayPacket other) {
        count = other.count;
        frame = other.frame;
        media = other.media == null ? null : other.media.clone();
        measures = other.measures;
        for (int i = 0; i < numbers.length; i++) {
            System.arraycopy(other.numbers[i], 0, numbers[i], 0, count);
        }
        System.arraycopy(other.depth, 0, depth, 0, count);
        System.arraycopy(other.samples, 0, samples, 0, count);
    }

    /** Whether all rays are light in vacuum. */
    public boolean isInVacuum() {
        int others = 0;
        for (int i = 0; i < count; i++) {
            others += slowness[i] == 1 ? 0 : 1;
        }
        return others == 0;
    }

    /** Multiplies the opening angle of all rays by a factor, such as the part of its pixel that a ray stands for. */
    public void narrow(double factor) {
        for (int i = 0; i < count; i++) {
            spread[i] *= factor;
        }
    }

    /** Moves the starts of all rays in space and time. */
    public void shift(double byX, double byY, double byZ, double byTime) {
        if (byX == 0 && byY == 0 && byZ == 0 && byTime == 0) {
            return;
        }
        for (int i = 0; i < count; i++) {
            x[i] += byX;
            y[i] += byY;
            z[i] += byZ;
            time[i] += byTime;
        }
    }

    /** Moves a ray that has just left the camera to the place of an earlier one. */
    public void move(int from, int to) {
        for (double[] numbers : setByCamera) {
            numbers[to] = numbers[from];
        }
        samples[to] = samples[from];
    }

    /** Puts what became of a ray in the place of an earlier one. */
    public void move(int from, int to, Ray ray) {
        samples[to] = samples[from];
        set(to, ray);
    }

    /** Keeps only the first rays. */
    public void keep(int newCount) {
        count = newCount;
    }

    /** The number of the sample to which a ray belongs. */
    public int sample(int index) {
        return samples[index];
    }

    /** Puts a ray in the place of another; what it starts on is forgotten. */
    public void set(int index, Ray ray) {
        x[index] = ray.x;
        y[index] = ray.y;
        z[index] = ray.z;
        dx[index] = ray.dx;
        dy[index] = ray.dy;
        dz[index] = ray.dz;
        time[index] = ray.time;
        slowness[index] = ray.slowness;
        frequency[index] = ray.frequency;
        directionLength[index] = ray.directionLength;
        width[index] = ray.width;
        windowFactor[index] = ray.windowFactor;
        throughput[index] = ray.throughput;
        depth[index] = ray.depth;
        spread[index] = ray.spread;
        if (media != null || ray.medium != null) {
            if (media == null) {
                // the other rays are in none
                media = new Medium[x.length];
            }
            media[index] = ray.medium;
        }
    }

    /** One of the rays. */
    public Ray ray(int index) {
        return copy(index, Ray.blank());
    }

    /** One of the rays, in memory that is used again. */
    public Ray copy(int index, Ray memory) {
        memory.frame = frame;
        memory.x = x[index];
        memory.y = y[index];
        memory.z = z[index];
        memory.dx = dx[index];
        memory.dy = dy[index];
        memory.dz = dz[index];
        memory.time = time[index];
        memory.slowness = slowness[index];
        memory.frequency = frequency[index];
        memory.directionLength = directionLength[index];
        memory.measures = measures;
        memory.width = width[index];
        memory.spread = spread[index];
        memory.windowFactor = windowFactor[index];
        memory.throughput = throughput[index];
        memory.medium = media == null ? null : media[index];
        memory.boundary = null;
        memory.part = 0;
        memory.depth = depth[index];
        return memory;
    }
}
