package tompkins.study;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * A law {@code y = factor x^slope}, fitted to points by least squares of the logarithms.
 *
 * @param slope the exponent
 * @param factor y at x = 1
 * @param rSquared the fraction of the spread of log y that the law explains, from 0 to 1
 */
record PowerLaw(double slope, double factor, double rSquared) {

    /** Fits a law; points that are not above 0 are left out. All numbers are NaN if fewer than two are left. */
    static PowerLaw fit(double[] x, double[] y) {
        double[][] logs = IntStream.range(0, x.length)
                .filter(i -> x[i] > 0 && y[i] > 0)
                .mapToObj(i -> new double[] {Math.log(x[i]), Math.log(y[i])})
                .toArray(double[][]::new);
        double meanX = Arrays.stream(logs).mapToDouble(log -> log[0]).average().orElse(Double.NaN);
        double meanY = Arrays.stream(logs).mapToDouble(log -> log[1]).average().orElse(Double.NaN);
        double xx = 0;
        double xy = 0;
        double yy = 0;
        for (double[] log : logs) {
            xx += (log[0] - meanX) * (log[0] - meanX);
            xy += (log[0] - meanX) * (log[1] - meanY);
            yy += (log[1] - meanY) * (log[1] - meanY);
        }
        double slope = xy / xx;
        return new PowerLaw(slope, Math.exp(meanY - slope * meanX), slope * xy / yy);
    }

    /** How the median error falls with a number; errors below three times that of the reference are left out. */
    static PowerLaw ofError(List<StudyPoint> points, ToDoubleFunction<StudyPoint> number) {
        List<StudyPoint> clear = points.stream()
                .filter(point -> point.medianError() > 3 * point.floor())
                .toList();
        return fit(
                clear.stream().mapToDouble(number).toArray(),
                clear.stream().mapToDouble(point -> point.medianError()).toArray());
    }
}
