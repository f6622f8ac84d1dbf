package tompkins.search;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import tompkins.primitive.Bounds;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.surface.Shadow;
import tompkins.surface.Surface;

/**
 * All primitives of one frame, ordered for searching: a bounding-volume tree for what has bounds, a list for infinite
 * planes and for scenes that are too small to need a tree. Immutable, shared by all threads.
 */
public final class ObjectTree {

    /** From this number of primitives a tree is faster than a list, as the study {@code tree} shows. */
    public static final int SMALLEST_TREE = 20;

    /** With fewer chords of a ray past what turns, more hits are missed, as the study {@code precision} shows. */
    public static final double CHORDS_PER_RADIAN = 16;

    /** Cost of visiting a node, in tests of a primitive. */
    private static final double NODE = 4;

    /** The same cost if most primitives are rods, whose test takes twice as long. */
    private static final double NODE_AMONG_RODS = 2;

    private final Primitive[] listed;
    private final TreeNode root;
    private final List<Primitive> bounded;
    private final List<Primitive> unbounded = new ArrayList<>();
    private final Bounds bounds;
    private final boolean mostlyLong;
    private final int size;
    private final Set<Surface> surfaces = Collections.newSetFromMap(new IdentityHashMap<>());
    private final List<RotatingGroup> rotating = new ArrayList<>();

    /** Orders primitives that have numbers and frames. */
    public ObjectTree(List<Primitive> primitives) {
        this(primitives, SMALLEST_TREE);
    }

    /** As above, with a tree from {@code smallestTree} bounded primitives upwards. */
    public ObjectTree(List<Primitive> primitives, int smallestTree) {
        this(primitives, smallestTree, CHORDS_PER_RADIAN);
    }

    /** As above, where a ray past what turns has so many chords while that turns by a radian. */
    public ObjectTree(List<Primitive> primitives, int smallestTree, double chordsPerRadian) {
        List<Primitive> searched = RotatingGroup.gather(primitives, chordsPerRadian);
        size = primitives.size();
        List<Primitive> withBounds = new ArrayList<>(searched.size());
        Bounds box = null;
        int rods = 0;
        // one pass in one loop: a mesh has millions of triangles, which a cold start would go through in slow code
        for (Primitive each : searched) {
            Bounds own = each.bounds();
            if (own == null) {
                unbounded.add(each);
            } else {
                withBounds.add(each);
                box = box == null ? own : box.with(own);
                rods += each instanceof CylinderPrimitive rod && rod.longAxis() != null ? 1 : 0;
            }
            if (each instanceof RotatingGroup group) {
                rotating.add(group);
                group.members().forEach(member -> surfaces.add(member.surface()));
            } else {
                surfaces.add(each.surface());
            }
        }
        bounds = box;
        Primitive[] ordered = withBounds.toArray(Primitive[]::new);
        boolean tree = ordered.length > 0 && ordered.length >= smallestTree;
        mostlyLong = rods > ordered.length / 2;
        root = tree ? TreeBuilder.build(ordered, mostlyLong ? NODE_AMONG_RODS : NODE) : null;
        bounded = List.of(ordered);
        listed = (tree ? unbounded : searched).toArray(Primitive[]::new);
    }

    /** Number of primitives. */
    public int size() {
        return size;
    }

    /** The primitives, in any order. */
    public List<Primitive> primitives() {
        return Stream.concat(bounded.stream(), unbounded.stream())
                .<Primitive>mapMulti((each, all) -> {
                    if (each instanceof RotatingGroup group) {
                        group.members().forEach(all);
                    } else {
                        all.accept(each);
                    }
                })
                .toList();
    }

    /** The surfaces of all primitives, each once: a mesh of a million triangles has one. */
    public Set<Surface> surfaces() {
        return Collections.unmodifiableSet(surfaces);
    }

    /** Whether something in it throws shadows. */
    public boolean throwsShadows() {
        return surfaces.stream().anyMatch(surface -> surface.shadow() != Shadow.NEVER);
    }

    /** The largest speed of each of the groups of primitives that turn together, in this frame. */
    public List<Double> rotationSpeeds() {
        return rotating.stream().map(RotatingGroup::largestSpeed).toList();
    }

    /** Whether something in it turns. */
    public boolean rotates() {
        return !rotating.isEmpty();
    }

    /** Whether most bounded primitives are much longer than wide, like rods. */
    boolean isMostlyLong() {
        return mostlyLong;
    }

    /** A box around the bounded primitives, or null if there are none. */
    Bounds bounds() {
        return bounds;
    }

    /** The primitives with bounds. */
    List<Primitive> bounded() {
        return bounded;
    }

    /** The primitives without bounds. */
    List<Primitive> unbounded() {
        return unbounded;
    }

    /** What is searched one by one, beside the tree. */
    Primitive[] listed() {
        return listed;
    }

    /** The tree, or null if there is none. */
    TreeNode root() {
        return root;
    }

    /**
     * Searches for the nearest primitive that a ray hits.
     *
     * @return whether there is one; {@code nearest} holds it
     */
    public boolean nearest(Ray ray, NearestHit nearest) {
        return nearest(ray, Primitive.NO_HIT, nearest);
    }

    /** As above, of what is not farther than a limit. */
    public boolean nearest(Ray ray, double limit, NearestHit nearest) {
        nearest.start(limit);
        for (Primitive primitive : listed) {
            nearest.test(primitive, ray);
        }
        nearest.count(0, listed.length);
        if (root != null) {
            searchTree(root, ray, nearest);
        }
        return nearest.primitive() != null;
    }

    /** Searches below a node for what is nearer than what was found before. */
    static void searchTree(TreeNode root, Ray ray, NearestHit nearest) {
        double x = ray.x;
        double y = ray.y;
        double z = ray.z;
        double inverseX = 1 / ray.dx;
        double inverseY = 1 / ray.dy;
        double inverseZ = 1 / ray.dz;
        TreeNode[] waiting = nearest.waiting;
        double[] entries = nearest.entries;
        int count = 0;
        int nodes = 0;
        int tests = 0;
        TreeNode node = root;
        if (root.entry(x, y, z, inverseX, inverseY, inverseZ, nearest.reach()) == TreeNode.MISSED) {
            node = null;
        }
        while (node != null) {
            nodes++;
            TreeNode next = null;
            if (node.primitives != null) {
                Primitive[] primitives = node.primitives;
                int to = node.to;
                for (int i = node.from; i < to; i++) {
                    nearest.test(primitives[i], ray);
                    tests++;
                }
            } else {
                double limit = nearest.reach();
                double low = node.low.entry(x, y, z, inverseX, inverseY, inverseZ, limit);
                double high = node.high.entry(x, y, z, inverseX, inverseY, inverseZ, limit);
                // the nearer half first, so that the other is often too far by then
                if (low <= high) {
                    next = low == TreeNode.MISSED ? null : node.low;
                    if (high != TreeNode.MISSED) {
                        waiting[count] = node.high;
                        entries[count++] = high;
                    }
                } else {
                    next = node.high;
                    if (low != TreeNode.MISSED) {
                        waiting[count] = node.low;
                        entries[count++] = low;
                    }
                }
            }
            while (next == null && count > 0) {
                count--;
                next = entries[count] > nearest.reach() ? null : waiting[count];
            }
            node = next;
        }
        nearest.count(nodes, tests);
    }

    /**
     * Something that throws a shadow on the start of a ray, or null.
     *
     * @param limit distance of the light
     * @param scratch memory for the search; its result is not touched
     */
    public Primitive shadow(Ray ray, double limit, NearestHit scratch) {
        for (Primitive primitive : listed) {
            if (primitive.shadows(ray, limit)) {
                return primitive;
            }
        }
        return root == null ? null : shadow(root, ray, 1 / ray.dx, 1 / ray.dy, 1 / ray.dz, limit, scratch);
    }

    private static Primitive shadow(
            TreeNode node,
            Ray ray,
            double inverseX,
            double inverseY,
            double inverseZ,
            double limit,
            NearestHit scratch) {
        if (node.entry(ray.x, ray.y, ray.z, inverseX, inverseY, inverseZ, limit) == TreeNode.MISSED) {
            return null;
        }
        scratch.count(1, 0);
        if (node.primitives == null) {
            Primitive shadow = shadow(node.low, ray, inverseX, inverseY, inverseZ, limit, scratch);
            return shadow != null ? shadow : shadow(node.high, ray, inverseX, inverseY, inverseZ, limit, scratch);
        }
        for (int i = node.from; i < node.to; i++) {
            scratch.count(0, 1);
            if (node.primitives[i].shadows(ray, limit)) {
                return node.primitives[i];
            }
        }
        return null;
    }
}
