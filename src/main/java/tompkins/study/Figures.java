package tompkins.study;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * What a trial finds; see {@link StudyPoint} for the meaning of each figure.
 *
 * @param rays rays that were followed, or evaluations of the integrand
 * @param seconds time of one thread
 * @param error the root mean square of the errors, or the figure that the study names instead
 * @param maximum the largest error
 * @param floor the root mean square error of the reference itself; 0 for an exact answer
 */
public record Figures(double rays, Spread seconds, Spread error, double maximum, double floor) {

    /** One run, with errors of either sign. */
    static Figures of(double rays, double seconds, double[] errors, double floor) {
        double maximum = Arrays.stream(errors).map(Math::abs).max().orElseThrow();
        return new Figures(rays, Spread.exact(seconds), Spread.exact(rootMeanSquare(errors)), maximum, floor);
    }

    /** A single figure in place of the errors, without a reference that could err. */
    static Figures of(double rays, double seconds, double figure) {
        return new Figures(rays, Spread.exact(seconds), Spread.exact(figure), figure, 0);
    }

    static double rootMeanSquare(double[] errors) {
        return Math.sqrt(
                Arrays.stream(errors).map(error -> error * error).average().orElseThrow());
    }

    /** Several runs of the same. */
    static Figures of(List<Figures> runs) {
        return new Figures(
                runs.stream().mapToDouble(Figures::rays).average().orElseThrow(),
                spread(runs, run -> run.seconds.middle()),
                spread(runs, run -> run.error.middle()),
                spread(runs, Figures::maximum).high(),
                runs.get(0).floor);
    }

    private static Spread spread(List<Figures> runs, ToDoubleFunction<Figures> figure) {
        return Spread.of(runs.stream().mapToDouble(figure).toArray());
    }
}
