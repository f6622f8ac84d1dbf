package tompkins.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Primitive;
import tompkins.primitive.Rotation;
import tompkins.primitive.TurningPath;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.surface.Shadow;

/**
 * All primitives that turn together, as one that fills the region through which they sweep. What turns into itself is
 * met as if it rested. For the others a ray is a curve: it is cut into pieces, a tree finds what the chord of each may
 * come near to, and that is met on the curve itself.
 */
final class RotatingGroup extends Primitive {

    /** The most pieces of a ray; beyond this they get longer, and more is missed. */
    private static final int MOST_CHORDS = 1 << 12;

    /** The most surfaces with gaps for light that are examined one behind the other. */
    private static final int MOST_PASSED = 1000;

    /** More than rounding leaves of a distance along the path, relative to it. */
    private static final double SAME = 1e-9;

    private final double chordsPerRadian;
    private final Rotation rotation;
    private final CylinderPrimitive swept;

    /** No point of the others comes nearer to the axis. */
    private final double hollow;

    /** What turns into itself, and is met as if it rested. */
    private final List<Primitive> round;

    /** The others in the order of the leaves of the tree; and a box around each, as leaves hold two. */
    private final Primitive[] others;

    private final TreeNode tree;
    private final TreeNode[] boxes;

    /** The memory of each thread. */
    private final ThreadLocal<Search> searches = ThreadLocal.withInitial(Search::new);

    private RotatingGroup(List<Primitive> turning, double chordsPerRadian) {
        super(turning.get(0).object(), turning.get(0).surface());
        this.chordsPerRadian = chordsPerRadian;
        setRestFrame(turning.get(0).restFrame());
        rotation = restFrame().rotation();
        swept = rotation.swept(turning);
        Map<Boolean, List<Primitive>> byRoundness =
                turning.stream().collect(Collectors.partitioningBy(rotation::turnsIntoItself));
        round = byRoundness.get(true);
        others = byRoundness.get(false).toArray(Primitive[]::new);
        hollow = Arrays.stream(others).mapToDouble(rotation::leastReach).min().orElse(0);
        tree = others.length == 0 ? null : TreeBuilder.build(others, 1);
        boxes = IntStream.range(0, others.length)
                .mapToObj(i -> new TreeNode(others[i].bounds(), others, i, i + 1))
                .toArray(TreeNode[]::new);
        setOrder(turning.get(0).order());
    }

    /** The same primitives, those that turn together as one, which is met on so many chords for each radian. */
    static List<Primitive> gather(List<Primitive> primitives, double chordsPerRadian) {
        List<Primitive> all = new ArrayList<>(primitives.size());
        for (int i = 0; i < primitives.size(); i++) {
            Rotation own = primitives.get(i).restFrame().rotation();
            int end = i + 1;
            while (own != null
                    && end < primitives.size()
                    && primitives.get(end).restFrame().rotation() == own) {
                end++;
            }
            all.add(own == null ? primitives.get(i) : new RotatingGroup(primitives.subList(i, end), chordsPerRadian));
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
        return Stream.concat(round.stream(), Arrays.stream(others)).toList();
    }

    @Override
    public double distance(Ray ray, double limit) {
        return search(ray, limit, 0).foundDistance;
    }

    /** Whether something else may lie at the place of the hit that was found last. */
    boolean isShared() {
        return searches.get().shared;
    }

    /** All hits of a ray up to a limit. */
    List<Hit> hits(Ray ray, double limit) {
        Search search = new Search();
        search.all = new ArrayList<>();
        search.of(ray, limit, 0);
        return search.all;
    }

    /** Looks for the nearest hit up to a limit, beyond what is known to be empty; the next search forgets it. */
    private Search search(Ray ray, double limit, double known) {
        Search search = searches.get();
        // the hit that was found last is often asked for
        if (known == 0 || known != search.foundDistance || !search.isOf(ray)) {
            search.of(ray, limit, known);
        }
        return search;
    }

    /** The search of a thread for what a ray meets, on one chord of its path after the other. */
    private final class Search {

        private final TurningPath path = new TurningPath(rotation);
        private final Chord chord = new Chord(path);
        private final Ray ray = Ray.blank();
        private double limit;

        /** The nearest primitive, or null, and its distance; and whether something else may lie at its place. */
        private Primitive found;

        private double foundDistance;
        private boolean shared;

        /** All hits, if somebody wants them; else null. */
        private List<Hit> all;

        void of(Ray newRay, double newLimit, double known) {
            ray.set(newRay);
            limit = newLimit;
            found = null;
            foundDistance = NO_HIT;
            shared = false;
            path.begin(ray);
            for (Primitive each : round) {
                double distance = each.distanceOff(ray, nearest());
                if (distance < NO_HIT) {
                    find(each, distance);
                }
            }
            if (tree == null || !path.enters(swept)) {
                return;
            }
            double entry = path.entry();
            double exit = path.exit();
            int chords =
                    1 + (int) Math.min(MOST_CHORDS, chordsPerRadian / Chord.PARTS * path.turning() * (exit - entry));
            double step = (exit - entry) / chords;
            int first = known > entry ? Math.max(0, (int) ((known - entry) / step) - 1) : 0;
            for (int i = first; i < chords && entry + i * step <= nearest(); i++) {
                double start = entry + i * step;
                double end = i + 1 == chords ? exit : entry + (i + 1) * step;
                if (!path.isWithin(hollow, start, end)) {
                    chord.take(start, end);
                    search(tree);
                }
            }
        }

        private double nearest() {
            return Math.min(limit, reach());
        }

        /** The distance up to which something at the place of what was found may lie. */
        private double reach() {
            return foundDistance + SAME * (foundDistance + path.size());
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

        private void search(TreeNode node) {
            if (!chord.isNear(node)) {
                return;
            }
            if (node.primitives == null) {
                search(node.low);
                search(node.high);
                return;
            }
            for (int i = node.from; i < node.to; i++) {
                double distance = chord.first(others[i], boxes[i], ray, nearest());
                if (distance > 0 && distance <= limit && distance < NO_HIT) {
                    find(others[i], distance);
                }
            }
        }

        /** Notes a hit if it is nearer than what was found before; of equally near ones the one listed first stays. */
        private void find(Primitive primitive, double distance) {
            if (all != null) {
                all.add(path.hit(ray, primitive, distance, Hit.blank()));
                return;
            }
            boolean first = distance < foundDistance
                    || distance == foundDistance && found != null && primitive.order() < found.order();
            boolean isNear = Math.min(distance, foundDistance) + SAME * (distance + path.size())
                    >= Math.max(distance, foundDistance);
            shared = isNear || shared && !first;
            if (first) {
                found = primitive;
                foundDistance = distance;
            }
        }

        private Hit hit(Ray of, Hit memory) {
            return path.hit(of, found, foundDistance, memory);
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
            Search search = search(rest, left, 0);
            if (search.found == null) {
                return false;
            }
            if (search.found.surface().shadow() == Shadow.ALWAYS) {
                return true;
            }
            Hit hit = search.hit(rest, Hit.blank());
            List<Hit> here = search.shared ? hits(rest, search.reach()) : List.of(hit.copy());
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
    public boolean overlaps(RayPacket rays, boolean oneStart, double farthest, double[] overlaps) {
        return swept.overlaps(rays, oneStart, farthest, overlaps);
    }

    @Override
    public double minimumAlong(double nx, double ny, double nz) {
        return swept.minimumAlong(nx, ny, nz);
    }
}
