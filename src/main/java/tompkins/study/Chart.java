package tompkins.study;

import java.util.List;
import java.util.function.Function;

/**
 * What a chart shows: one curve for each method of a problem, on logarithmic axes.
 *
 * @param problem the problem whose measurements are drawn
 * @param title above the chart
 * @param across the axis across
 * @param up the axis upwards
 * @param pareto whether to mark the best points, which no other beats on both axes; less is better on both
 * @param own the method of the program, whose points are drawn last and larger; empty if there is none
 */
public record Chart(String problem, String title, Axis across, Axis up, boolean pareto, String own) {

    /**
     * An axis.
     *
     * @param label what it is, with its unit
     * @param value the place of a measurement; upwards, with error bars
     */
    public record Axis(String label, Function<StudyPoint, Spread> value) {}

    /** Seconds of one thread. */
    static final Axis SECONDS = new Axis("seconds (one thread)", StudyPoint::seconds);

    /** Root mean square error in linear light. */
    static final Axis ERROR = new Axis("RMS error in linear light (white = 1)", StudyPoint::error);

    /** Rays that were followed. */
    static final Axis RAYS = new Axis("rays", point -> Spread.exact(point.rays()));

    /** Error against time. */
    public static Chart errorAgainstTime(String problem, String title, String own) {
        return new Chart(problem, title, SECONDS, ERROR, true, own);
    }

    /** The name of its file. */
    public String file(StudyKind kind) {
        return kind + "-" + problem + ".png";
    }

    /** The setting of the trials across. */
    static Axis setting(String label) {
        return new Axis(label, point -> Spread.exact(point.setting()));
    }

    /** The place of a measurement across. */
    double x(StudyPoint point) {
        return across.value.apply(point).middle();
    }

    /** The place of a measurement upwards. */
    Spread y(StudyPoint point) {
        return up.value.apply(point);
    }

    /**
     * The measurements that this chart shows: those of its problem and of the parts of it, {@code problem:part}, that
     * can be drawn on logarithmic axes.
     */
    public List<StudyPoint> drawn(List<StudyPoint> all) {
        return all.stream()
                .filter(point -> (point.problem() + ":").startsWith(problem + ":"))
                .filter(point -> x(point) > 0 && y(point).low() > 0)
                .toList();
    }
}
