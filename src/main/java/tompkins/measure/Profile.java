package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import tompkins.trace.RenderPlan;

/**
 * What a picture shows along a straight line in it: points at equal distances, both ends among them.
 *
 * @param points what they show, from the first end to the second
 */
public record Profile(List<Sighting> points) {

    /** The most points of a profile. */
    private static final int MOST = 10_000;

    /** Checks nothing; keeps a copy. */
    public Profile {
        points = List.copyOf(points);
    }

    /**
     * Follows the rays of a line at as many points as it has pixels, 2 to 10 000.
     *
     * @param goesOn asked before each point
     * @return the profile, or null if it was not to go on
     */
    public static Profile between(RenderPlan plan, Vector2dc first, Vector2dc last, BooleanSupplier goesOn) {
        Vector2d way = last.sub(first, new Vector2d()).absolute();
        int count = (int) Math.max(2, Math.min(MOST, Math.round(Math.max(way.x, way.y)) + 1));
        List<Sighting> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            if (!goesOn.getAsBoolean()) {
                return null;
            }
            Vector2d point = first.lerp(last, i / (count - 1.0), new Vector2d());
            points.add(Sighting.of(plan, point.x, point.y));
        }
        return new Profile(points);
    }
}
