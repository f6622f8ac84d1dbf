package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.ray.Colour;
import tompkins.trace.RenderPlan;

/**
 * Finds edges on straight ways through a picture: points where two rays that lie ever closer together still see
 * different objects, or colours that differ by a tenth. It follows rays and not pixels, so that an edge is found to far
 * less than a pixel, and light that changes gradually is not an edge.
 */
final class Edges {

    /** Rays per pixel of the way; objects narrower than half a pixel may be missed. */
    private static final int RAYS_PER_PIXEL = 2;

    private static final int MOST_RAYS = 20_000;

    /** Halvings of the way between two rays, of half a pixel at first. */
    private static final int HALVINGS = 36;

    /** The least difference of colours at an edge; see {@link #difference}. */
    private static final double JUMP = 0.1;

    /** Added to the brightness with which a difference is compared, so that noise in the dark is no edge. */
    private static final double DARK = 0.02;

    /** The difference between different objects, whatever their colours: more than between any colours. */
    private static final double OTHER_OBJECT = 1;

    private final RenderPlan plan;

    /** Finds edges in the picture of a plan. */
    Edges(RenderPlan plan) {
        this.plan = plan;
    }

    /** The points, in pixels, just behind the first edges on a way, in their order, up to a number. */
    List<Vector2dc> on(Vector2dc from, Vector2dc to, int most) {
        List<Vector2dc> found = new ArrayList<>();
        int steps = (int) Math.max(1, Math.min(MOST_RAYS, Math.ceil(RAYS_PER_PIXEL * from.distance(to))));
        Sighting before = Sighting.of(plan, from.x(), from.y());
        for (int i = 1; i <= steps && found.size() < most; i++) {
            Vector2d point = from.lerp(to, (double) i / steps, new Vector2d());
            Sighting next = Sighting.of(plan, point.x, point.y);
            edge(before, next).ifPresent(found::add);
            before = next;
        }
        return found;
    }

    /**
     * The point just behind the edge at which the brightness of points of a line changes most; none if it has no edge.
     */
    Optional<Vector2dc> largestStep(List<Sighting> points) {
        int before = 0;
        for (int i = 1; i < points.size() - 1; i++) {
            before = step(points, i) > step(points, before) ? i : before;
        }
        return edge(points.get(before), points.get(before + 1));
    }

    private static double step(List<Sighting> points, int before) {
        return Math.abs(points.get(before + 1).brightness() - points.get(before).brightness());
    }

    /** The point just behind the edge between two rays that follow each other: where they differ most. */
    private Optional<Vector2dc> edge(Sighting start, Sighting end) {
        Sighting first = start;
        Sighting second = end;
        for (int i = 0; i < HALVINGS && difference(first, second) > JUMP; i++) {
            Sighting between = Sighting.of(plan, (first.x() + second.x()) / 2, (first.y() + second.y()) / 2);
            if (difference(first, between) >= difference(between, second)) {
                second = between;
            } else {
                first = between;
            }
        }
        return difference(first, second) > JUMP ? Optional.of(new Vector2d(second.x(), second.y())) : Optional.empty();
    }

    /** How much two rays differ, from 0 to 1. */
    private static double difference(Sighting one, Sighting other) {
        if (object(one) != object(other)) {
            return OTHER_OBJECT;
        }
        Colour first = one.colour();
        Colour second = other.colour();
        return Math.max(
                difference(first.red(), second.red()),
                Math.max(difference(first.green(), second.green()), difference(first.blue(), second.blue())));
    }

    private static double difference(double one, double other) {
        return Math.abs(one - other) / (DARK + Math.max(one, other));
    }

    private static Object object(Sighting sighting) {
        return sighting.hit() == null ? null : sighting.hit().object();
    }
}
