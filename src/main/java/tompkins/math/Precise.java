package tompkins.math;

/** Differences that cancel, evaluated without losing digits. All errors are in units of u = 2^-53. */
public final class Precise {

    private Precise() {}

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
