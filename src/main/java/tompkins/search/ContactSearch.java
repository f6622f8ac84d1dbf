package tompkins.search;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import tompkins.primitive.FlatPrimitive;
import tompkins.primitive.PlanePrimitive;
import tompkins.primitive.Primitive;
import tompkins.ray.Contact;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.sceneobject.Cone;
import tompkins.sceneobject.TriangleMesh;
import tompkins.spacetime.PointFrame;
import tompkins.surface.Refractive;
import tompkins.surface.Shadow;

/**
 * Finds all surfaces at the place that a ray has met, in all frames, and puts them in order: first closed shapes and
 * media that the ray leaves, then thin sheets, then what it enters; among these what lets light pass before what is
 * opaque. Made for one place.
 */
public final class ContactSearch {

    private final List<Met> met = new ArrayList<>();

    /** What a ray meets, and its cosine to the normal where what is met rests. */
    private record Met(Primitive primitive, Hit hit, Ray ray, double cosine) {

        static Met of(Ray ray, Hit hit) {
            Primitive primitive = (Primitive) hit.boundary;
            if (!hit.runs) {
                return new Met(primitive, hit, ray, hit.cosine(ray));
            }
            PointFrame point =
                    new PointFrame(hit, primitive.restFrame().rotation().law());
            Ray inside = point.enter(ray);
            return new Met(primitive, hit, ray, point.normal().dot(inside.dx, inside.dy, inside.dz));
        }

        /** The distance in units that are the same in all frames. */
        double share() {
            return hit.distance / ray.directionLength;
        }

        boolean isAtPlaceOf(Met other) {
            double steepest = Math.max(Math.abs(cosine), Math.abs(other.cosine));
            double apart = Math.abs(share() - other.share()) * ray.directionLength;
            return apart * steepest <= Contact.ROUNDING * Contact.size(ray, hit.distance);
        }

        /** Whether the ray, which starts on nothing that it knows of, starts at this place. */
        boolean isAtStart() {
            return ray.depth == 0
                    && ray.boundary == null
                    && ray.contact == null
                    && hit.distance * Math.abs(cosine) <= Contact.ROUNDING * Contact.size(ray, 0);
        }

        /** The index behind, divided by that before. */
        double indexRatio() {
            double ratio = primitive.surface() instanceof Refractive medium ? medium.indexRatio() : 1;
            return cosine < 0 ? ratio : 1 / ratio;
        }

        boolean isRefractive() {
            return primitive.surface() instanceof Refractive;
        }

        boolean isSheet() {
            boolean isFlat = primitive instanceof FlatPrimitive || primitive instanceof PlanePrimitive;
            boolean isPart = primitive.object() instanceof Cone || primitive.object() instanceof TriangleMesh;
            return isFlat && !isPart && !isRefractive();
        }

        boolean letsPass() {
            return primitive.surface().shadow() != Shadow.ALWAYS;
        }

        /** Whether both are one surface, whose pieces meet here. */
        boolean isOneWith(Met other) {
            return primitive.object() == other.primitive.object()
                    ? cosine < 0 == other.cosine < 0
                    : primitive instanceof FlatPrimitive piece
                            && other.primitive instanceof FlatPrimitive neighbour
                            && piece.surface().equals(neighbour.surface())
                            && piece.meetsInPlane(neighbour, hit);
        }
    }

    /** Whether a shadow falls on the start of a ray, whose light has come through layers of surfaces at that place. */
    public static boolean isInShadow(Ray ray) {
        return ray.contact != null
                && ray.contact.passed().stream()
                        .filter(hit -> hit.frame == ray.frame)
                        .anyMatch(hit -> ((Primitive) hit.boundary).throwsShadowAt(ray, hit.copy()));
    }

    /** Adds what a ray meets among the objects of its frame up to a distance. */
    public void add(ObjectTree objects, Ray ray, double limit) {
        for (Primitive primitive : objects.listed()) {
            add(primitive, ray, limit);
        }
        if (objects.root() != null) {
            add(objects.root(), ray, limit);
        }
    }

    private void add(TreeNode node, Ray ray, double limit) {
        if (node.entry(ray.x, ray.y, ray.z, 1 / ray.dx, 1 / ray.dy, 1 / ray.dz, limit) == TreeNode.MISSED) {
            return;
        }
        if (node.primitives == null) {
            add(node.low, ray, limit);
            add(node.high, ray, limit);
            return;
        }
        for (int i = node.from; i < node.to; i++) {
            add(node.primitives[i], ray, limit);
        }
    }

    private void add(Primitive primitive, Ray ray, double limit) {
        if (primitive instanceof RotatingGroup group) {
            group.hits(ray, limit).forEach(hit -> met.add(Met.of(ray, hit)));
            return;
        }
        double distance = primitive.distanceOff(ray, limit);
        if (distance < Primitive.NO_HIT) {
            met.add(Met.of(ray, primitive.hit(ray, distance)));
        }
    }

    /**
     * The surfaces at the nearest place; null if there is only one. There are no layers to be met where the ray starts
     * there, or where media of one index touch.
     */
    public Contact contact() {
        met.sort(Comparator.comparingDouble(Met::share).thenComparingInt(each -> each.primitive.order()));
        List<Met> here =
                met.stream().filter(each -> each.isAtPlaceOf(met.get(0))).toList();
        List<Hit> all = here.stream().map(Met::hit).toList();
        if (here.get(0).isAtStart()) {
            return Contact.of(all, List.of());
        }
        return here.size() == 1 ? null : Contact.of(all, layers(inOrder(unique(here))));
    }

    private static List<Met> unique(List<Met> here) {
        List<Met> unique = new ArrayList<>();
        for (Met each : here) {
            if (unique.stream().noneMatch(each::isOneWith)) {
                unique.add(each);
            }
        }
        unique.sort(Comparator.comparingInt(each -> each.primitive.order()));
        return unique;
    }

    private static List<Met> inOrder(List<Met> listed) {
        List<Met> ordered = new ArrayList<>();
        addGroup(listed, each -> !each.isSheet() && each.cosine > 0, ordered);
        addGroup(listed, Met::isSheet, ordered);
        addGroup(listed, each -> !each.isSheet() && !(each.cosine > 0), ordered);
        return ordered;
    }

    private static void addGroup(List<Met> listed, Predicate<Met> belongs, List<Met> ordered) {
        List<Met> passing = new ArrayList<>(
                listed.stream().filter(belongs).filter(Met::letsPass).toList());
        // the way back is the same
        if (!passing.isEmpty() && passing.get(0).cosine > 0) {
            Collections.reverse(passing);
        }
        ordered.addAll(passing);
        listed.stream().filter(belongs).filter(each -> !each.letsPass()).forEach(ordered::add);
    }

    /** Media at one place that rest in one frame are one boundary, or none if there is one index on both sides. */
    private static List<List<Hit>> layers(List<Met> ordered) {
        List<List<Hit>> layers = new ArrayList<>();
        for (int from = 0, to; from < ordered.size(); from = to) {
            Met first = ordered.get(from);
            double ratio = first.indexRatio();
            to = from + 1;
            while (first.isRefractive()
                    && to < ordered.size()
                    && ordered.get(to).isRefractive()
                    && ordered.get(to).hit.frame == first.hit.frame) {
                ratio *= ordered.get(to++).indexRatio();
            }
            if (to == from + 1 || !Refractive.isNothing(ratio)) {
                layers.add(ordered.subList(from, to).stream().map(Met::hit).toList());
            }
        }
        return layers;
    }
}
