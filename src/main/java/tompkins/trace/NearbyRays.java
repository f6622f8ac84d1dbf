package tompkins.trace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.joml.Vector3d;
import tompkins.camera.EyeView;
import tompkins.camera.SamplePositions;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/**
 * Rays through places of the picture near that of a sample, which share its place on the lens and its time. Those that
 * leave the scene remember their way: what they have met. One for each thread.
 */
final class NearbyRays implements PathObserver {

    private static final long MIX = 0x9E3779B97F4A7C15L;

    private final SampleTracer tracer;

    /** The ways up to where the branches began that are being followed. */
    private long[] forks = new long[8];

    private int forked;

    private EyeView eye;
    private SamplePositions places;
    private int sample;

    /** The number of samples begun so far. */
    private long begun;

    private Leaving current;
    private long way;

    /** The rays of one place of the picture that leave the scene. Memory that is used again for other places. */
    static final class Leaving {

        /** The direction in which all have left the camera. */
        final Vector3d look = new Vector3d();

        private final List<Ray> rays = new ArrayList<>();
        private long[] ways = new long[8];
        private int count;

        // the place, and the sample that it belongs to
        private double x;
        private double y;
        private long begun;

        private boolean isAt(double newX, double newY, long newBegun) {
            return x == newX && y == newY && begun == newBegun;
        }

        private void begin(double newX, double newY, long newBegun) {
            x = newX;
            y = newY;
            begun = newBegun;
            count = 0;
        }

        private void add(Ray ray, long way) {
            if (count == rays.size()) {
                rays.add(Ray.blank());
            }
            if (count == ways.length) {
                ways = Arrays.copyOf(ways, 2 * count);
            }
            rays.get(count).set(ray);
            ways[count] = way;
            count++;
        }

        /** The number of the ray that is most like another; -1 if there is none. */
        int like(Ray ray) {
            int best = -1;
            for (int i = 0; i < count; i++) {
                if (rays.get(i).depth == ray.depth && (best < 0 || nearer(i, best, ray))) {
                    best = i;
                }
            }
            return best;
        }

        /** The ray that has taken a way; of several that one whose direction is nearest to that of another; or null. */
        Ray onWay(long wanted, Ray ray) {
            int best = -1;
            for (int i = 0; i < count; i++) {
                if (ways[i] == wanted && (best < 0 || nearer(i, best, ray))) {
                    best = i;
                }
            }
            return best < 0 ? null : rays.get(best);
        }

        private boolean nearer(int one, int other, Ray ray) {
            return cosine(rays.get(one), ray) > cosine(rays.get(other), ray);
        }

        private static double cosine(Ray one, Ray other) {
            return one.dx * other.dx + one.dy * other.dy + one.dz * other.dz;
        }

        /** A ray. */
        Ray ray(int number) {
            return rays.get(number);
        }

        /** The way of a ray. */
        long way(int number) {
            return ways[number];
        }
    }

    /**
     * The rays.
     *
     * @param tracerFor makes a tracer that an observer watches
     */
    NearbyRays(Function<PathObserver, SampleTracer> tracerFor) {
        tracer = tracerFor.apply(this);
    }

    /** Begins with a sample of an eye. */
    void begin(EyeView seeing, SamplePositions newPlaces, int newSample) {
        eye = seeing;
        places = newPlaces;
        sample = newSample;
        begun++;
    }

    /** Where the sample lies in the picture of the eye, in pixels from the left edge. */
    double x() {
        return places.x(sample);
    }

    /** Where it lies, in pixels from the upper edge. */
    double y() {
        return places.y(sample);
    }

    /** Makes {@code memory} the rays of a place of the picture, if it is not that already. */
    Leaving at(double x, double y, Leaving memory) {
        if (!memory.isAt(x, y, begun)) {
            memory.begin(x, y, begun);
            current = memory;
            way = 0;
            tracer.sampleBeside(eye, places, sample, x, y);
        }
        return memory;
    }

    @Override
    public void starts(Ray ray) {
        current.look.set(ray.dx, ray.dy, ray.dz);
    }

    @Override
    public void branches() {
        if (forked == forks.length) {
            forks = Arrays.copyOf(forks, 2 * forked);
        }
        forks[forked++] = way;
    }

    @Override
    public void returns() {
        way = forks[--forked];
    }

    @Override
    public void hits(Frame frame, Ray ray, Hit hit, Primitive primitive) {
        int inScene = frame == Frame.SCENE ? 1 : 0;
        way = ((way + inScene) * MIX + primitive.order()) * MIX + hit.part + 1;
    }

    @Override
    public void leaves(Frame frame, Ray ray) {
        if (frame == Frame.SCENE) {
            current.add(ray, way);
        }
    }
}
