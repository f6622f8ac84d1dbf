package tompkins.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Face;
import tompkins.primitive.Primitive;
import tompkins.primitive.RayStarts;
import tompkins.primitive.Rotation;
import tompkins.primitive.TurningPath;
import tompkins.ray.Contact;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.surface.Shadow;

/**
 * All primitives that turn together, as one that fills the region through which they sweep. What turns into itself is
 * met as if it rested. For the others a ray is a curve: it is cut into pieces that turn by an eighth of a radian at
 * most, each of which lies near its chord; a tree finds what the chord may come near to, and the faces of that are met
 * on the curve itself.
 */
final class RotatingGroup extends Primitive {

    /** Chords in a radian. */
    private static final int CHORDS = 8;

    /** The most chords of a ray; beyond this they get longer, which is slower but misses no hit. */
    private static final int MOST_CHORDS = 10_000;

    /** The most surfaces with gaps for light that are examined one behind the other. */
    private static final int MOST_PASSED = 1000;

    private final Rotation rotation;
    private final CylinderPrimitive swept;
    private final Primitive[] round;
    private final TreeNode tree;

    /**
     * What the tree holds, in the order of its leaves; a box around each, as leaves hold two; and the faces of each.
     */
    private final Primitive[] others;

    private final TreeNode[] boxes;
    private final Face[][] faces;

    // the cylinder through which the others sweep
    private final double low;
    private final double high;
    private final double radius;

    /** No point of the others comes nearer to the axis. */
    private final double hollow;

    /** The memory of each thread. */
    private final ThreadLocal<Search> searches = ThreadLocal.withInitial(Search::new);

    private RotatingGroup(List<Primitive> members) {
        super(members.get(0).object(), members.get(0).surface());
        rotation = members.get(0).restFrame().rotation();
        swept = rotation.swept(members);
        Map<Boolean, List<Primitive>> byRoundness = members.stream()
                .collect(Collectors.partitioningBy(member -> member.isRoundAbout(rotation.centre(), rotation.axis())));
        round = byRoundness.get(true).toArray(Primitive[]::new);
        others = byRoundness.get(false).toArray(Primitive[]::new);
        CylinderPrimitive others = this.others.length == 0 ? swept : rotation.swept(List.of(this.others));
        low = others.start().sub(rotation.centre()).dot(rotation.axis());
        high = others.end().sub(rotation.centre()).dot(rotation.axis());
        radius = others.radius();
        hollow = Arrays.stream(this.others)
                .mapToDouble(rotation::leastReach)
                .min()
                .orElse(0);
        tree = this.others.length == 0 ? null : TreeBuilder.build(this.others, 1);
        boxes = IntStream.range(0, this.others.length)
                .mapToObj(i -> new TreeNode(this.others[i].bounds(), this.others, i, i + 1))
                .toArray(TreeNode[]::new);
        faces = Arrays.stream(this.others)
                .map(member -> member.faces(rotation.centre()).toArray(Face[]::new))
                .toArray(Face[][]::new);
        setRestFrame(members.get(0).restFrame());
        setOrder(members.get(0).order());
    }

    /** The same primitives, those that turn together as one. */
    static List<Primitive> gather(List<Primitive> primitives) {
        List<Primitive> all = new ArrayList<>(primitives.size());
        for (int i = 0; i < primitives.size(); i++) {
            Rotation own = primitives.get(i).restFrame().rotation();
            int end = i + 1;
            while (own != null
                    && end < primitives.size()
                    && primitives.get(end).restFrame().rotation() == own) {
                end++;
            }
            all.add(own == null ? primitives.get(i) : new RotatingGroup(primitives.subList(i, end)));
            i = end - 1;
        }
        return all;
    }

    /** The largest speed of a point of it, in the frame in which it turns. */
    double largestSpeed() {
        return Math.abs(rotation.angularSpeed())
                * members().stream().mapToDouble(rotation::reach).max().orElse(0);
    }

    /** The primitives themselves. */
    List<Primitive> members() {
        List<Primitive> all = new ArrayList<>(List.of(round));
        all.addAll(List.of(others));
        return all;
    }

    @Override
    public double distance(Ray ray, double limit) {
        return search(ray, limit, 0).foundDistance();
    }

    /** Whether something else may lie at the place of the hit that was found last. */
    boolean isShared() {
        return searches.get().path.isShared();
    }

    /** All hits of a ray up to a limit. */
    List<Hit> hits(Ray ray, double limit) {
        Search search = new Search();
        search.all = new ArrayList<>();
        search.of(ray, limit, 0);
        return search.all;
    }

    /** Looks for the nearest hit up to a limit, beyond what is known to be empty; the next search forgets it. */
    private TurningPath search(Ray ray, double limit, double known) {
        Search search = searches.get();
        // the hit that was found last is often asked for
        if (known == 0 || known != search.path.foundDistance() || !search.isOf(ray)) {
            search.of(ray, limit, known);
        }
        return search.path;
    }

    /** The search of a thread for what a ray meets, on one chord of its path after the other. */
    private final class Search {

        final TurningPath path = new TurningPath(rotation);
        private final Ray ray = Ray.blank();
        private double limit;

        /** All hits, if somebody wants them; else null. */
        private List<Hit> all;

        // the present piece of the path, and the straight line between its ends
        private double from;
        private double to;
        private double sag;
        private double x;
        private double y;
        private double z;
        private double inverseX;
        private double inverseY;
        private double inverseZ;

        void of(Ray newRay, double newLimit, double known) {
            ray.set(newRay);
            limit = newLimit;
            path.begin(ray);
            for (Primitive each : round) {
                double distance = each.distanceOff(ray, nearest());
                if (distance < NO_HIT) {
                    find(each, TurningPath.ROUND, distance);
                }
            }
            if (tree == null || !path.enters(low, high, radius, hollow)) {
                return;
            }
            double entry = path.entry();
            double exit = path.exit();
            int chords = 1 + (int) Math.min(MOST_CHORDS, CHORDS * path.turning() * (exit - entry));
            double step = (exit - entry) / chords;
            int first = known > entry ? Math.max(0, (int) ((known - entry) / step) - 1) : 0;
            for (int i = first; i < chords && entry + i * step <= nearest(); i++) {
                double start = entry + i * step;
                double end = i + 1 == chords ? exit : entry + (i + 1) * step;
                if (!path.isInHollow(start, end)) {
                    take(start, end);
                    search(tree);
                }
            }
        }

        private void find(Primitive primitive, int part, double distance) {
            path.find(primitive, part, distance);
            if (all != null) {
                all.add(path.hit(ray, Hit.blank()));
                path.forget();
            }
        }

        /** Whether the last search was for the same ray. */
        boolean isOf(Ray other) {
            return ray.x == other.x
                    && ray.y == other.y
                    && ray.z == other.z
                    && ray.dx == other.dx
                    && ray.dy == other.dy
                    && ray.dz == other.dz
                    && ray.time == other.time
                    && ray.slowness == other.slowness
                    && ray.boundary == other.boundary
                    && ray.part == other.part
                    && ray.contact == other.contact;
        }

        private double nearest() {
            return Math.min(limit, path.reach());
        }

        private void take(double newFrom, double newTo) {
            from = newFrom;
            to = newTo;
            path.take(from, to, radius);
            sag = path.sag(to - from);
            path.go(from);
            x = path.x();
            y = path.y();
            z = path.z();
            path.go(to);
            inverseX = 1 / (path.x() - x);
            inverseY = 1 / (path.y() - y);
            inverseZ = 1 / (path.z() - z);
        }

        private void search(TreeNode node) {
            if (!node.isNear(x, y, z, inverseX, inverseY, inverseZ, sag)) {
                return;
            }
            if (node.primitives == null) {
                search(node.low);
                search(node.high);
                return;
            }
            for (int i = node.from; i < node.to; i++) {
                if (!boxes[i].isNear(x, y, z, inverseX, inverseY, inverseZ, sag)) {
                    continue;
                }
                int startPart = from == 0 ? ray.partOf(others[i]) : Contact.NOWHERE;
                for (Face face : faces[i]) {
                    double start = startPart == face.part() ? face.leaving(path) : from;
                    double distance = face.first(path, start, to);
                    if (distance <= limit && distance < NO_HIT) {
                        find(others[i], face.part(), distance);
                    }
                }
            }
        }
    }

    @Override
    public Hit hit(Ray ray, double distance, Hit memory) {
        return search(ray, distance, distance).hit(ray, memory);
    }

    @Override
    public boolean shadows(Ray ray, double limit) {
        Ray rest = ray;
        double left = limit;
        for (int meeting = 0; meeting < MOST_PASSED; meeting++) {
            TurningPath path = search(rest, left, 0);
            if (path.found() == null) {
                return false;
            }
            if (path.found().surface().shadow() == Shadow.ALWAYS) {
                return true;
            }
            Hit hit = path.hit(rest, Hit.blank());
            List<Hit> here = path.isShared() ? hits(rest, path.reach()) : List.of(hit.copy());
            Ray met = rest;
            if (here.stream().anyMatch(each -> ((Primitive) each.boundary).throwsShadowAt(met, each))) {
                return true;
            }
            left -= hit.distance;
            rest = rest.shadowBeyond(hit);
        }
        return false;
    }

    @Override
    public boolean overlaps(RayPacket rays, RayStarts starts, double[] overlaps) {
        return swept.overlaps(rays, starts, overlaps);
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        return swept.minimumAlong(nx, ny, nz);
    }
}
