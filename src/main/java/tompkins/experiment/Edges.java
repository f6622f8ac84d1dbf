package tompkins.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tompkins.measure.Sighting;
import tompkins.ray.Colour;

/**
 * Finds edges on straight ways through a picture: places where two rays that lie ever closer together still see
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

    /**
     * Added to the brightness with which a difference is compared, so that noise in the dark is not an edge; white is
     * 1.
     */
    private static final double DARK = 0.02;

    /** The difference between different objects, whatever their colours: more than between any colours. */
    private static final double OTHER_OBJECT = 1;

    private final PictureRays rays;

    /** Finds edges in a picture. */
    Edges(PictureRays rays) {
        this.rays = rays;
    }

    /** The places just behind the first edges on a way, in their order, up to a number. */
    List<Place> on(Place from, Place to, int most) {
        List<Place> found = new ArrayList<>();
        int steps = steps(from, to);
        Sighting before = rays.at(from);
        for (int i = 1; i <= steps && found.size() < most; i++) {
            Sighting next = rays.at(from.towards(to, (double) i / steps));
            edge(from, to, (i - 1.0) / steps, before, (double) i / steps, next).ifPresent(found::add);
            before = next;
        }
        return found;
    }

    private int steps(Place from, Place to) {
        double x = to.x(rays.plan().width()) - from.x(rays.plan().width());
        double y = to.y(rays.plan().height()) - from.y(rays.plan().height());
        return (int) Math.max(1, Math.min(MOST_RAYS, Math.ceil(RAYS_PER_PIXEL * Math.hypot(x, y))));
    }

    /** The place just behind the edge between two rays that follow each other: where they differ most. */
    private Optional<Place> edge(Place from, Place to, double start, Sighting atStart, double end, Sighting atEnd) {
        double here = start;
        double there = end;
        Sighting first = atStart;
        Sighting second = atEnd;
        for (int i = 0; i < HALVINGS && difference(first, second) > JUMP; i++) {
            double middle = (here + there) / 2;
            Sighting between = rays.at(from.towards(to, middle));
            if (difference(first, between) >= difference(between, second)) {
                there = middle;
                second = between;
            } else {
                here = middle;
                first = between;
            }
        }
        return difference(first, second) > JUMP ? Optional.of(from.towards(to, there)) : Optional.empty();
    }

    /** How much two rays differ, from 0 to 1. */
    private static double difference(Sighting one, Sighting other) {
        if (object(one) != object(other)) {
            return OTHER_OBJECT;
        }
        Colour first = one.life().colour();
        Colour second = other.life().colour();
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
