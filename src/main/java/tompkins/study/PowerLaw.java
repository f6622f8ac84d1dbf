package tompkins.study;

import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * A law {@code y = factor x^slope}, fitted to points by least squares of the logarithms.
 *
 * @param slope the exponent
 * @param factor y at x = 1
 * @param rSquared the share of the spread of log y that the law explains, from 0 to 1
 */
record PowerLaw(double slope, double factor, double rSquared) {

    /** Fits a law; points that are not above 0 are left out. All numbers are NaN if fewer than two are left. */
    static PowerLaw fit(double[] x, double[] y) {
        int count = 0;
        double sumX = 0;
        double sumY = 0;
        for (int i = 0; i < x.length; i++) {
            if (x[i] > 0 && y[i] > 0) {
                count++;
                sumX += Math.log(x[i]);
                sumY += Math.log(y[i]);
            }
        }
        double xx = 0;
        double xy = 0;
        double yy = 0;
        for (int i = 0; i < x.length; i++) {
            if (x[i] > 0 && y[i] > 0) {
                double dx = Math.log(x[i]) - sumX / count;
                double dy = Math.log(y[i]) - sumY / count;
                xx += dx * dx;
                xy += dx * dy;
                yy += dy * dy;
            }
        }
        double slope = xy / xx;
        return new PowerLaw(slope, Math.exp((sumY - slope * sumX) / count), slope * xy / yy);
    }

    /** How the median error falls with a number; errors below three times that of the reference are left out. */
    static PowerLaw ofError(List<Measurement> points, ToDoubleFunction<Measurement> number) {
        List<Measurement> clear = points.stream()
                .filter(point -> point.medianError() > 3 * point.floor())
                .toList();
        return fit(
                clear.stream().mapToDouble(number).toArray(),
                clear.stream().mapToDouble(point -> point.medianError()).toArray());
    }
}
