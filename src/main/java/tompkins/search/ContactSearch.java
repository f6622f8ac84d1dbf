package tompkins.search;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import tompkins.primitive.FlatPrimitive;
import tompkins.primitive.PlanePrimitive;
import tompkins.primitive.Primitive;
import tompkins.ray.Contact;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.spacetime.MomentaryRestFrame;
import tompkins.surface.Refractive;
import tompkins.surface.Shadow;
import tompkins.surface.Surface;

/**
 * Finds all surfaces at the place that a ray has met, in all frames, and puts them in order: first closed shapes and
 * media that the ray leaves, then thin sheets, then what it enters; among these what lets light pass before what is
 * opaque, and else as they are listed, or the other way round for a ray that comes from behind.
 */
public final class ContactSearch {

    private final List<Met> met = new ArrayList<>();

    /** What a ray meets, and its cosine to the normal where what is met rests. */
    private record Met(Primitive primitive, Hit hit, Ray ray, double cosine) {

        static Met of(Ray ray, Hit hit) {
            Primitive primitive = (Primitive) hit.boundary;
            if (!hit.pointMoves) {
                return new Met(primitive, hit, ray, hit.cosine(ray));
            }
            MomentaryRestFrame point =
                    new MomentaryRestFrame(hit, primitive.restFrame().rotation().law());
            Ray inside = point.enter(ray);
            return new Met(primitive, hit, ray, point.normal().dot(inside.dx, inside.dy, inside.dz));
        }

        /** The distance in units that are the same in all frames. */
        double fraction() {
            return hit.distance / ray.directionLength;
        }

        /** Whether this lies a distance before or behind its hit, but for rounding. */
        boolean isApart(double distance, double otherCosine) {
            double steepest = Math.max(Math.abs(cosine), Math.abs(otherCosine));
            return Math.abs(distance) * steepest > Contact.ROUNDING * Contact.size(ray, hit.distance);
        }

        boolean isAtPlaceOf(Met other) {
            return !isApart((fraction() - other.fraction()) * ray.directionLength, other.cosine);
        }

        /** Whether the ray, which has just left the camera, starts at this place. */
        boolean isAtStart() {
            return ray.depth == 0 && ray.boundary == null && ray.contact == null && !isApart(hit.distance, 0);
        }

        Surface surface() {
            return primitive.surface();
        }

        /** The index behind, divided by that before; 1 if this is no boundary of a medium. */
        double indexRatio() {
            double ratio = surface() instanceof Refractive medium ? medium.indexRatio() : 1;
            return cosine < 0 ? ratio : 1 / ratio;
        }

        /** The number of its group in the order: what the ray leaves, thin sheets, what it enters. */
        int group() {
            boolean isFlat = primitive instanceof FlatPrimitive || primitive instanceof PlanePrimitive;
            boolean isSheet = isFlat && !primitive.object().isBody() && !(surface() instanceof Refractive);
            return isSheet ? 1 : cosine > 0 ? 0 : 2;
        }

        boolean isOpaque() {
            return surface().shadow() == Shadow.ALWAYS;
        }

        /** Whether both are opaque, belong to one group, and look different. */
        boolean isRivalOf(Met other) {
            boolean isSame = surface().equals(other.surface()) && !surface().usesCoordinates();
            return isOpaque() && other.isOpaque() && group() == other.group() && !isSame;
        }

        /** Whether both are one surface, whose pieces meet here. */
        boolean isOneWith(Met other) {
            return primitive.object() == other.primitive.object()
                    ? cosine < 0 == other.cosine < 0
                    : surface().equals(other.surface()) && isAtEdge() && other.isAtEdge();
        }

        private boolean isAtEdge() {
            return primitive instanceof FlatPrimitive piece && piece.isAtEdge(ray, hit.distance);
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

    /** The surfaces at the nearest place; null if there is only one. Where the ray starts there, no layers are met. */
    public Contact contact() {
        met.sort(Comparator.comparingDouble(Met::fraction).thenComparingInt(each -> each.primitive.order()));
        List<Met> here =
                met.stream().filter(each -> each.isAtPlaceOf(met.get(0))).toList();
        List<Hit> all = here.stream().map(Met::hit).toList();
        if (here.get(0).isAtStart()) {
            return Contact.of(all, List.of(), List.of());
        }
        if (here.size() == 1) {
            return null;
        }
        List<Met> ordered = inOrder(here);
        return Contact.of(all, layers(ordered), rivals(ordered));
    }

    private static List<Hit> rivals(List<Met> ordered) {
        Met first = ordered.stream().filter(Met::isOpaque).findFirst().orElse(ordered.get(0));
        return ordered.stream()
                .filter(each -> each == first || each.isRivalOf(first))
                .map(Met::hit)
                .toList();
    }

    private static List<Met> inOrder(List<Met> here) {
        List<Met> listed = new ArrayList<>();
        for (Met each : here) {
            if (listed.stream().noneMatch(each::isOneWith)) {
                listed.add(each);
            }
        }
        listed.sort(Comparator.comparingInt(each -> each.primitive.order()));
        List<Met> ordered = new ArrayList<>();
        for (int group = 0; group < 3; group++) {
            int number = group;
            Stream<Met> passing = listed.stream().filter(each -> each.group() == number && !each.isOpaque());
            List<Met> inGroup = new ArrayList<>(passing.toList());
            // so that the way back is the same
            if (!inGroup.isEmpty() && inGroup.get(0).cosine > 0) {
                Collections.reverse(inGroup);
            }
            ordered.addAll(inGroup);
            listed.stream()
                    .filter(each -> each.group() == number && each.isOpaque())
                    .forEach(ordered::add);
        }
        return ordered;
    }

    /** Media at one place that rest in one frame are one boundary, or none if there is one index on both sides. */
    private static List<List<Hit>> layers(List<Met> ordered) {
        List<List<Hit>> layers = new ArrayList<>();
        for (int from = 0, to; from < ordered.size(); from = to) {
            Met first = ordered.get(from);
            double ratio = first.indexRatio();
            for (to = from + 1; to < ordered.size() && isOneBoundary(first, ordered.get(to)); to++) {
                ratio *= ordered.get(to).indexRatio();
            }
            if (to == from + 1 || !Refractive.isNothing(ratio)) {
                layers.add(ordered.subList(from, to).stream().map(Met::hit).toList());
            }
        }
        return layers;
    }

    private static boolean isOneBoundary(Met one, Met next) {
        return one.surface() instanceof Refractive
                && next.surface() instanceof Refractive
                && one.hit.frame == next.hit.frame;
    }
}
