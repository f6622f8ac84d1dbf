package tompkins.study;

import java.util.List;

/**
 * One point of a chart.
 *
 * @param problem what was worked out
 * @param method how
 * @param setting the number that was varied: samples per pixel, gamma, objects; the study says which
 * @param rays rays that were followed, or evaluations of the integrand
 * @param seconds time of one thread
 * @param error the root mean square of the errors, or the figure that the study names instead
 * @param maximum the largest error
 * @param floor the root mean square error of the reference itself; 0 for an exact answer
 */
public record StudyPoint(
        String problem,
        String method,
        double setting,
        double rays,
        Spread seconds,
        Spread error,
        double maximum,
        double floor) {

    /** The error, or the figure in its place, in the middle of the runs. */
    double medianError() {
        return error.middle();
    }

    /** The time of one thread in the middle of the runs. */
    double medianSeconds() {
        return seconds.middle();
    }

    /** The measurements of one method at one problem, of all those given and in their order. */
    static List<StudyPoint> of(String problem, String method, List<StudyPoint> all) {
        return all.stream()
                .filter(point ->
                        point.problem().equals(problem) && point.method().equals(method))
                .toList();
    }

    /**
     * The measurement of one method at one problem with one setting.
     *
     * @throws java.util.NoSuchElementException if it is not among those given
     */
    static StudyPoint of(String problem, String method, double setting, List<StudyPoint> all) {
        return of(problem, method, all).stream()
                .filter(point -> point.setting() == setting)
                .findFirst()
                .orElseThrow();
    }
}
