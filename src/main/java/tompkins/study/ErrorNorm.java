package tompkins.study;

import java.util.stream.IntStream;

/**
 * The size of a set of errors.
 *
 * @param rootMeanSquare RMSE
 * @param maximum the largest
 */
record ErrorNorm(double rootMeanSquare, double maximum) {

    /** The norm of errors of either sign. */
    static ErrorNorm of(double[] errors) {
        double squares = 0;
        double maximum = 0;
        for (double error : errors) {
            squares += error * error;
            maximum = Math.max(maximum, Math.abs(error));
        }
        return new ErrorNorm(Math.sqrt(squares / errors.length), maximum);
    }

    /** The norm of the difference of two sets of values. */
    static ErrorNorm of(double[] values, double[] reference) {
        return of(IntStream.range(0, values.length)
                .mapToDouble(i -> values[i] - reference[i])
                .toArray());
    }
}
