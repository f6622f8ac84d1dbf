package tompkins.trace;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
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
 * leave the scene remember their way: what they have met. All of them are followed, or those of one way alone. One for
 * each thread.
 */
final class NearbyRays implements PathObserver {

    private static final long MIX = 0x9E3779B97F4A7C15L;

    private final SampleTracer tracer;

    /** The lengths of the way where the branches began that are being followed. */
    private final Deque<Integer> forks = new ArrayDeque<>();

    private EyeView eye;
    private SamplePositions places;
    private int sample;

    /** The number of samples begun so far. */
    private long begun;

    private Leaving current;
    private final Way way = new Way();

    private final Way wanted = new Way();
    private boolean wantsAll;

    /** What a ray has met: for each hit, a number that stands for it and all before it. */
    private static final class Way {

        private long[] marks = new long[8];
        private int length;

        private void add(Frame frame, Hit hit, Primitive primitive) {
            if (length == marks.length) {
                marks = Arrays.copyOf(marks, 2 * length);
            }
            int inScene = frame == Frame.SCENE ? 1 : 0;
            marks[length] = ((end() + inScene) * MIX + primitive.order()) * MIX + hit.part + 1;
            length++;
        }

        private long end() {
            return length == 0 ? 0 : marks[length - 1];
        }

        private void set(Way other) {
            if (marks.length < other.length) {
                marks = new long[other.marks.length];
            }
            System.arraycopy(other.marks, 0, marks, 0, other.length);
            length = other.length;
        }

        private boolean beginsWith(Way other) {
            return other.length <= length && (other.length == 0 || marks[other.length - 1] == other.end());
        }
    }

    /** The rays of one place of the picture that leave the scene. Memory that is used again for other places. */
    static final class Leaving {

        /** The direction in which all have left the camera. */
        final Vector3d look = new Vector3d();

        private final List<Ray> rays = new ArrayList<>();
        private final List<Way> ways = new ArrayList<>();
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

        private void add(Ray ray, Way way) {
            if (count == rays.size()) {
                rays.add(Ray.blank());
                ways.add(new Way());
            }
            rays.get(count).set(ray);
            ways.get(count).set(way);
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
        private Ray onWay(Way wanted, Ray ray) {
            int best = -1;
            for (int i = 0; i < count; i++) {
                if (ways.get(i).length == wanted.length
                        && wanted.beginsWith(ways.get(i))
                        && (best < 0 || nearer(i, best, ray))) {
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

    /** Makes {@code memory} the rays of a place of the picture on all ways, if it is not that already. */
    Leaving at(double x, double y, Leaving memory) {
        if (!memory.isAt(x, y, begun)) {
            wantsAll = true;
            trace(x, y, memory);
        }
        return memory;
    }

    /** From now on the way is wanted that one of some rays has taken. */
    void want(Leaving leaving, int number) {
        wanted.set(leaving.ways.get(number));
    }

    /**
     * The ray of a place of the picture on the way that is wanted; of several that one whose direction is nearest to
     * that of another; or null.
     *
     * @param memory of its own, or one that has all rays of the place or will get them
     */
    Ray onWay(double x, double y, Ray ray, boolean alone, Leaving memory) {
        if (alone) {
            wantsAll = false;
            trace(x, y, memory);
        } else {
            at(x, y, memory);
        }
        return memory.onWay(wanted, ray);
    }

    private void trace(double x, double y, Leaving memory) {
        memory.begin(x, y, begun);
        current = memory;
        way.length = 0;
        tracer.sampleBeside(eye, places, sample, x, y);
    }

    @Override
    public void starts(Ray ray) {
        current.look.set(ray.dx, ray.dy, ray.dz);
    }

    @Override
    public void branches() {
        forks.push(way.length);
    }

    @Override
    public void returns() {
        way.length = forks.pop();
    }

    @Override
    public void hits(Frame frame, Ray ray, Hit hit, Primitive primitive) {
        way.add(frame, hit, primitive);
    }

    @Override
    public boolean follows() {
        return wantsAll || wanted.beginsWith(way);
    }

    @Override
    public void leaves(Frame frame, Ray ray) {
        if (frame == Frame.SCENE) {
            current.add(ray, way);
        }
    }
}
