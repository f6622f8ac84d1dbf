package tompkins.trace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
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
    private int cameraFrame;
    private long way;

    /** The rays of one place of the picture that leave the scene. Memory that is used again for other places. */
    static final class Leaving {

        /** The direction in which all have left the camera. */
        final Vector3d look = new Vector3d();

        private final List<Left> all = new ArrayList<>();

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
            all.clear();
        }

        /** The one that is most like a ray; null if there is none. */
        Left like(Ray ray) {
            return nearest(ray, left -> left.ray.depth == ray.depth);
        }

        /** The ray that has taken a way; of several that one whose direction is nearest to that of another; or null. */
        Ray onWay(long wanted, Ray ray) {
            Left found = nearest(ray, left -> left.way == wanted);
            return found == null ? null : found.ray;
        }

        private Left nearest(Ray ray, Predicate<Left> wanted) {
            Left best = null;
            for (Left left : all) {
                if (wanted.test(left) && (best == null || left.cosine(ray) > best.cosine(ray))) {
                    best = left;
                }
            }
            return best;
        }
    }

    /** A ray that has left the scene, and its way. */
    record Left(Ray ray, long way) {

        private double cosine(Ray other) {
            return ray.dx * other.dx + ray.dy * other.dy + ray.dz * other.dz;
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
        return places.x[sample];
    }

    /** Where it lies, in pixels from the upper edge. */
    double y() {
        return places.y[sample];
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
        cameraFrame = ray.frame;
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
    public void hits(Hit hit) {
        int inScene = hit.frame == cameraFrame ? 0 : 1;
        way = ((way + inScene) * MIX + ((Primitive) hit.boundary).order()) * MIX + hit.part + 1;
    }

    @Override
    public void leaves(Ray ray) {
        if (ray.frame != cameraFrame) {
            current.all.add(new Left(Ray.blank().set(ray), way));
        }
    }
}
