package tompkins.study;

import java.util.Arrays;

/**
 * The size of many errors.
 *
 * @param rootMeanSquare RMSE
 * @param percentile what 99.9 % of the errors stay below
 * @param maximum the largest
 */
record ErrorNorm(double rootMeanSquare, double percentile, double maximum) {

    private static final double SHARE = 0.999;

    /** The norm of errors of either sign. */
    static ErrorNorm of(double[] errors) {
        double[] sizes = new double[errors.length];
        double squares = 0;
        for (int i = 0; i < errors.length; i++) {
            sizes[i] = Math.abs(errors[i]);
            squares += errors[i] * errors[i];
        }
        Arrays.sort(sizes);
        int place = (int) Math.min(sizes.length - 1, Math.ceil(SHARE * sizes.length));
        return new ErrorNorm(Math.sqrt(squares / errors.length), sizes[place], sizes[sizes.length - 1]);
    }

    /** The norm of the difference of two sets of values. */
    static ErrorNorm of(double[] values, double[] reference) {
        double[] errors = new double[values.length];
        for (int i = 0; i < errors.length; i++) {
            errors[i] = values[i] - reference[i];
        }
        return of(errors);
    }
}
