package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.ToDoubleFunction;
import tompkins.trace.RenderPlan;

/**
 * What a picture shows along a straight line in it: places at equal distances, both ends among them.
 *
 * @param places what they show, from the first end to the second
 */
public record Profile(List<Sighting> places) {

    /** The most places of a profile. */
    public static final int MOST = 10_000;

    /** Checks nothing; keeps a copy. */
    public Profile {
        places = List.copyOf(places);
    }

    /** As many places as a line between two others has pixels. */
    public static int count(double x1, double y1, double x2, double y2) {
        return (int) Math.max(2, Math.min(MOST, Math.round(Math.max(Math.abs(x2 - x1), Math.abs(y2 - y1))) + 1));
    }

    /**
     * Follows the rays of a line.
     *
     * @param count number of places, 2 to {@link #MOST}
     * @param goesOn asked before each place
     * @return the profile, or null if it was not to go on
     */
    public static Profile between(
            RenderPlan plan, double x1, double y1, double x2, double y2, int count, BooleanSupplier goesOn) {
        List<Sighting> places = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            if (!goesOn.getAsBoolean()) {
                return null;
            }
            double part = i / (count - 1.0);
            places.add(Sighting.of(plan, x1 + part * (x2 - x1), y1 + part * (y2 - y1)));
        }
        return new Profile(places);
    }

    /** Numbers of all places. */
    public double[] values(ToDoubleFunction<Sighting> number) {
        return places.stream().mapToDouble(number).toArray();
    }

    /** The place in pixels, x and y, of an edge in some numbers; null if there is none. */
    public double[] edge(ToDoubleFunction<Sighting> number) {
        double place = EdgeFinder.edge(values(number));
        if (Double.isNaN(place)) {
            return null;
        }
        Sighting first = places.get(0);
        Sighting last = places.get(places.size() - 1);
        double part = place / (places.size() - 1);
        return new double[] {first.x() + part * (last.x() - first.x()), first.y() + part * (last.y() - first.y())};
    }
}
