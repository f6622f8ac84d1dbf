package tompkins.search;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import org.joml.Vector3dc;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;

/**
 * The primitives as a lamp sees them: a grid of directions, each with the primitives that stand there, the nearest
 * first. A shadow ray tests only those in its direction that are nearer to the lamp than its start (the light buffer of
 * Haines and Greenberg 1986). Built once for a scene and a lamp that stands outside it, or for a piece of the way of a
 * lamp that passes; then a cell holds everything that is seen there from any place of that piece.
 */
public final class LampShadows {

    /**
     * From this number of primitives the tree answers first: one picture may ask for less than it takes to fill cells.
     */
    static final int MANY = 100_000;

    private final LightBufferProjection view;
    private final ObjectTree objects;
    private final Primitive[] everywhere;

    /** Null as long as they are not filled. */
    private final LightBuffer cells;

    private final AtomicInteger asked = new AtomicInteger();

    /** The same with its cells, once another thread has filled them. */
    private volatile LampShadows filled;

    private LampShadows(LightBufferProjection view, ObjectTree objects, LightBuffer cells) {
        this.view = view;
        this.objects = objects;
        this.cells = cells;
        everywhere = objects.unbounded().toArray(Primitive[]::new);
    }

    /**
     * The grid of a lamp, or null if none can be made: the lamp stands among the primitives, or they are so long that
     * the tree is faster, or there are none.
     */
    public static LampShadows of(Vector3dc position, ObjectTree objects) {
        return of(position, position, objects);
    }

    /** As above, for a lamp on its straight way from one place to another; null also if the way is too long. */
    static LampShadows of(Vector3dc from, Vector3dc to, ObjectTree objects) {
        Bounds all = objects.bounds();
        if (all == null) {
            return null;
        }
        LightBufferProjection view = LightBufferProjection.of(from, to, all);
        LampShadows empty = view == null ? null : new LampShadows(view, objects, null);
        return empty == null || objects.size() >= MANY ? empty : empty.filled();
    }

    /** The same with its cells, or null if the tree is faster. */
    private LampShadows filled() {
        LightBuffer all = LightBuffer.of(view, objects.bounded());
        return all == null ? null : new LampShadows(view, objects, all);
    }

    /**
     * The grid for the next shadow ray, or null if the tree is to answer. Among very many primitives it does until so
     * many rays have asked that another thread has filled the cells; the answers are the same.
     */
    public LampShadows gridOrNull() {
        if (cells != null) {
            return this;
        }
        int enough = objects.size();
        if (asked.get() < enough && asked.incrementAndGet() == enough) {
            ForkJoinPool.commonPool().execute(() -> filled = filled());
        }
        return filled;
    }

    /**
     * Whether something throws a shadow on a hit.
     *
     * @param ray the ray from the hit to the lamp
     * @param fraction the part of its way that the lamp has covered, from 0 to 1
     * @param limit distance of the lamp
     * @param counts takes note of the work
     */
    public boolean shadows(Hit from, Ray ray, double fraction, double limit, RayCounts counts) {
        for (Primitive primitive : everywhere) {
            if (shadows(primitive, from, ray, limit, counts)) {
                return true;
            }
        }
        int part = view.part(ray.dx, ray.dy, ray.dz, fraction);
        if (part == LightBufferProjection.OUTSIDE) {
            return false;
        }
        int cell = LightBufferProjection.cell(part);
        int end = cells.end(cell);
        int place = BufferEntry.place(part);
        int distance = BufferEntry.distance(limit);
        for (int i = cells.first(cell); i < end; i++) {
            long entry = cells.entry(i);
            if (BufferEntry.isFarther(entry, distance)) {
                return false;
            }
            if (BufferEntry.isSeen(entry, place) && shadows(cells.primitive(i), from, ray, limit, counts)) {
                return true;
            }
        }
        return false;
    }

    private static boolean shadows(Primitive primitive, Hit from, Ray ray, double limit, RayCounts counts) {
        if (primitive.leavesConvexShape(from, ray.dx, ray.dy, ray.dz)) {
            return false;
        }
        counts.tests++;
        return primitive.shadows(ray, limit);
    }
}
