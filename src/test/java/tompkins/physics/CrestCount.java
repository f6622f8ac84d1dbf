package tompkins.physics;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Event;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/**
 * Counts crests: a clock on an object sends a signal at each of its ticks, and what arrives at the lens, by whatever
 * way, tells how fast the clock is seen to run. That is the frequency ratio, found from places and times of rays alone:
 * neighbouring rays, a little later and a little beside, say how the lens must look to go on seeing the same point, and
 * how the time of that point goes on.
 */
final class CrestCount {

    /** Steps in pixels and in time. */
    private static final double STEP = 1.0 / 1024;

    private final Studio studio;
    private final RenderPlan[] plans = new RenderPlan[5];

    /** The rays of a studio with a pinhole whose shutter opens for all rays at one time. */
    CrestCount(Studio studio) {
        this.studio = studio;
        for (int i = 0; i < plans.length; i++) {
            plans[i] = RenderPlan.of(at((i - 2) * STEP), i == 0 ? null : plans[i - 1]);
        }
    }

    private Studio at(double later) {
        double time = studio.camera().shutter().openingTime();
        return studio.withCamera(studio.camera().withShutter(new AperturePlaneShutter(time + later)));
    }

    /**
     * A hit of the main branch, and what was counted there.
     *
     * @param way what was hit until then
     * @param told the frequency ratio (camera/object) that the program tells
     * @param counted the rate at which a clock on the object is seen to run
     */
    record Counted(SampleHistory.Encounter hit, String way, double told, double counted) {

        @Override
        public String toString() {
            return "told " + told + ", counted " + counted + " by way of " + way;
        }
    }

    private static String way(List<SampleHistory.Encounter> hits) {
        return hits.stream()
                .map(hit -> hit.surface().getClass().getSimpleName() + (hit.movesByItself() ? " that moves" : ""))
                .collect(Collectors.joining(", "));
    }

    /** The hits on the way of a ray for which crests can be counted: those whose surroundings are smooth. */
    List<Counted> at(double x, double y) {
        SampleHistory life = life(2, x, y);
        List<Counted> counted = new ArrayList<>();
        if (life == null) {
            return counted;
        }
        List<SampleHistory.Encounter> hits = life.mainHits();
        for (int i = 0; i < hits.size() && !turnsWithoutPhase(hits.subList(0, i)); i++) {
            double once = rate(life, i, x, y, 1);
            double twice = rate(life, i, x, y, 2);
            if (Math.abs(once - twice) < 1e-4 * Math.abs(once)) {
                // two steps cancel what grows with their square
                counted.add(new Counted(
                        hits.get(i),
                        way(hits.subList(0, i + 1)),
                        hits.get(i).rest().dopplerFactor(),
                        once + (once - twice) / 3));
            }
        }
        return counted;
    }

    /** Windows and lenses turn rays and leave the time of light as it is, which no wave can do. */
    private static boolean turnsWithoutPhase(List<SampleHistory.Encounter> hits) {
        return hits.stream().anyMatch(hit -> !hit.surface().keepsPhase());
    }

    private SampleHistory life(int plan, double x, double y) {
        return SampleHistory.of(plans[plan], x, y, 0, 0);
    }

    private double rate(SampleHistory middle, int hit, double x, double y, int steps) {
        double step = steps * STEP;
        Event right = difference(middle, hit, life(2, x - step, y), life(2, x + step, y));
        Event down = difference(middle, hit, life(2, x, y - step), life(2, x, y + step));
        Event later = difference(middle, hit, life(2 - steps, x, y), life(2 + steps, x, y));
        if (right == null || down == null || later == null) {
            return Double.NaN;
        }
        // how far right and down the same point is seen later
        Vector3dc perX = right.position();
        Vector3dc perY = down.position();
        Vector3dc moved = later.position();
        double xx = perX.dot(perX);
        double xy = perX.dot(perY);
        double yy = perY.dot(perY);
        double determinant = xx * yy - xy * xy;
        double ofX = perX.dot(moved);
        double ofY = perY.dot(moved);
        double columns = (yy * ofX - xy * ofY) / determinant;
        double rows = (xx * ofY - xy * ofX) / determinant;
        return (later.time() - columns * right.time() - rows * down.time()) / (2 * step);
    }

    /** The difference of the events of two hits on the same thing in its rest frame; null if the ways are different. */
    private static Event difference(SampleHistory middle, int hit, SampleHistory before, SampleHistory after) {
        return isSameWay(middle, before, hit) && isSameWay(middle, after, hit)
                ? after.mainHits()
                        .get(hit)
                        .rest()
                        .event()
                        .minus(before.mainHits().get(hit).rest().event())
                : null;
    }

    private static boolean isSameWay(SampleHistory one, SampleHistory other, int hit) {
        if (other == null || other.mainHits().size() <= hit) {
            return false;
        }
        for (int i = 0; i <= hit; i++) {
            SampleHistory.Encounter first = one.mainHits().get(i);
            SampleHistory.Encounter second = other.mainHits().get(i);
            Vector3d turned = first.rest().normal().sub(second.rest().normal(), new Vector3d());
            if (first.object() != second.object() || turned.length() > 0.1) {
                return false;
            }
        }
        return true;
    }
}
