package tompkins.study;

/** Areas of parts of the unit disc, in closed form. */
final class DiscArea {

    private DiscArea() {}

    /** The fraction of the disc with x below c. */
    static double below(double c) {
        double edge = Math.max(-1, Math.min(1, c));
        return 0.5 + 2 * chord(edge) / Math.PI;
    }

    /**
     * The fraction of the disc and the unit square around 0 where {@code x + u s + v t} is below c, with (s, t) in the
     * square: the second integral of {@link #below}, differenced.
     */
    static double below(double c, double u, double v) {
        return (twice(c + (u + v) / 2) - twice(c + (u - v) / 2) - twice(c - (u - v) / 2) + twice(c - (u + v) / 2))
                / (u * v);
    }

    /** The integral of sqrt(1 - x^2) from 0. */
    private static double chord(double x) {
        return (x * Math.sqrt(Math.max(0, 1 - x * x)) + Math.asin(x)) / 2;
    }

    /** The second integral of {@link #below(double)} from far below. */
    private static double twice(double c) {
        if (c <= -1) {
            return 0;
        }
        double x = Math.min(1, c);
        double root = Math.sqrt(1 - x * x);
        double arc = Math.asin(x);
        double cubes = (x * (5 - 2 * x * x) * root + 3 * arc) / 24;
        double arcs = ((2 * x * x - 1) * arc + x * root) / 4;
        double inner = x * x / 4 + (arcs + (x * root + arc) / 2 - cubes) / Math.PI;
        return inner - INNER_AT_LEFT + (c > 1 ? (c * c - 1) / 2 : 0);
    }

    private static final double INNER_AT_LEFT = 0.25 + (-Math.PI / 8 - Math.PI / 4 + 3 * Math.PI / 48) / Math.PI;
}
