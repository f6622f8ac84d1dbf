package tompkins.math;

import java.util.stream.DoubleStream;

/** Arithmetic that would lose digits, evaluated without losing them. All errors are in units of u = 2^-53. */
public final class Precise {

    /** The least power of ten of {@link #decimal}: ten to the power of its size has a place in a double. */
    public static final int LEAST_POWER = -22;

    private static final double[] POWERS_OF_TEN =
            DoubleStream.iterate(1, power -> 10 * power).limit(1 - LEAST_POWER).toArray();

    private Precise() {}

    /**
     * The double that is nearest to {@code digits 10^power}; NaN if twice the working precision does not tell, as half
     * way between two doubles, or if the power is above 0 or below {@link #LEAST_POWER}.
     *
     * @param digits from 0 to 2^62
     */
    public static double decimal(long digits, long power) {
        if (power > 0 || power < LEAST_POWER) {
            return Double.NaN;
        }
        double divisor = POWERS_OF_TEN[(int) -power];
        double high = digits;
        double quotient = high / divisor;
        // of digits and of the quotient, each without an error
        double rest = (Math.fma(-quotient, divisor, high) + (digits - (long) high)) / divisor;
        // 64 times as much as the rest may be wrong
        double error = 0x1p-98 * quotient;
        double nearest = quotient + (rest - error);
        return nearest == quotient + (rest + error) ? nearest : Double.NaN;
    }

    /**
     * The difference of products {@code a b - c d} with an error of at most 2 u of the result (Kahan; Jeannerod, Louvet
     * and Muller 2013), where the plain expression has 2 u of the larger product.
     */
    public static double differenceOfProducts(double a, double b, double c, double d) {
        double cd = c * d;
        double error = Math.fma(-c, d, cd);
        return Math.fma(a, b, -cd) + error;
    }

    /**
     * {@code 1 - x^2 - y^2 - z^2} summed in twice the working precision. The plain sum loses gamma^2 u of the result
     * for a velocity (x, y, z); this one is right to 2 u, and it is above 0 only where the exact sum is.
     */
    public static double oneMinusSquares(double x, double y, double z) {
        double high = 1;
        double low = 0;
        for (int axis = 0; axis < 3; axis++) {
            double value = axis == 0 ? x : axis == 1 ? y : z;
            double square = value * value;
            double squareError = Math.fma(value, value, -square);
            double sum = high - square;
            double part = sum - high;
            double sumError = (high - (sum - part)) + (-square - part);
            low += sumError - squareError;
            high = sum;
        }
        return high + low;
    }
}
