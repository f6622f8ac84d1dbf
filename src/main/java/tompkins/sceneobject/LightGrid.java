package tompkins.sceneobject;

import java.util.List;
import org.joml.Vector3dc;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;

/**
 * The primitives as a lamp sees them: a grid of directions, each with the primitives that stand there, the nearest
 * first. A shadow ray asks only those of its direction (the light buffer of Haines and Greenberg 1986) that are nearer
 * to the lamp than its start. Built once for a scene and a lamp that stands outside it.
 */
public final class LightGrid {

    /** Cells along each side of the grid of this number of primitives at most, and of more. */
    private static final int FEW_PRIMITIVES = 20_000;

    private static final int SIDE_FOR_FEW = 128;
    private static final int SIDE_FOR_MANY = 256;

    private static final Occluder[] NONE = {};

    private final LampView view;
    private final Primitive[] everywhere;
    private final Occluder[][] cells;

    private LightGrid(LampView view, Primitive[] everywhere, Occluder[][] cells) {
        this.view = view;
        this.everywhere = everywhere;
        this.cells = cells;
    }

    /**
     * The grid of a lamp, or null if none can be made: the lamp stands among the primitives, or they are so many and
     * long that the tree is faster, or there are none.
     */
    public static LightGrid of(Vector3dc position, ObjectTree objects) {
        List<Primitive> bounded = objects.bounded();
        if (bounded.isEmpty()) {
            return null;
        }
        Bounds all = bounded.get(0).bounds();
        for (Primitive primitive : bounded) {
            all = all.with(primitive.bounds());
        }
        LampView view = LampView.of(position, all, bounded.size() <= FEW_PRIMITIVES ? SIDE_FOR_FEW : SIDE_FOR_MANY);
        Occluder[][] cells = view == null ? null : LightCells.of(position, view, bounded);
        return cells == null ? null : new LightGrid(view, objects.unbounded().toArray(Primitive[]::new), cells);
    }

    /** Whether this is the grid of the lamp at (x, y, z). */
    public boolean isOf(double lampX, double lampY, double lampZ) {
        return view.isOf(lampX, lampY, lampZ);
    }

    /**
     * Whether something throws a shadow on a hit.
     *
     * @param dx unit vector from the hit to the lamp
     * @param dy its second component
     * @param dz its third component
     * @param limit distance of the lamp
     * @param memory for the ray
     * @param counts takes note of the work
     */
    public boolean shadows(Hit from, double dx, double dy, double dz, double limit, Ray memory, RayCounts counts) {
        Ray ray = null;
        int tests = 0;
        boolean shadow = false;
        for (int i = 0; i < everywhere.length && !shadow; i++) {
            if (!everywhere[i].surelyMisses(from, dx, dy, dz)) {
                ray = ray == null ? memory.setShadow(from, dx, dy, dz) : ray;
                shadow = everywhere[i].shadows(ray, limit);
                tests++;
            }
        }
        Occluder[] seen = shadow ? NONE : cell(dx, dy, dz);
        for (int i = 0; i < seen.length && !shadow; i++) {
            if (!seen[i].isNear(dx, dy, dz)) {
                continue;
            }
            if (seen[i].leastDistance() > limit) {
                break;
            }
            if (!seen[i].primitive().surelyMisses(from, dx, dy, dz)) {
                ray = ray == null ? memory.setShadow(from, dx, dy, dz) : ray;
                shadow = seen[i].primitive().shadows(ray, limit);
                tests++;
            }
        }
        counts.tests += tests;
        return shadow;
    }

    private Occluder[] cell(double dx, double dy, double dz) {
        int cell = view.cell(dx, dy, dz);
        Occluder[] seen = cell < 0 ? null : cells[cell];
        return seen == null ? NONE : seen;
    }
}
