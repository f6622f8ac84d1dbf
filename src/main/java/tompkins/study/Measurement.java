package tompkins.study;

/**
 * One point of a chart.
 *
 * @param problem what was worked out
 * @param method how
 * @param setting the number that was varied: samples for each pixel, gamma, objects; the study says which
 * @param rays rays that were followed, or evaluations of the integrand
 * @param seconds time of one thread
 * @param error root mean square of the error
 * @param percentile the error that 99.9 % of the values stay below
 * @param maximum the largest error
 * @param floor the error of the reference itself; 0 for an exact answer
 */
public record Measurement(
        String problem,
        String method,
        double setting,
        double rays,
        Spread seconds,
        Spread error,
        double percentile,
        double maximum,
        double floor) {}
