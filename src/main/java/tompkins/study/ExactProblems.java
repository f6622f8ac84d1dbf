package tompkins.study;

import java.util.List;

/**
 * What a pixel may see through the lens, and what may pass it in uniform motion while the shutter is open, with the
 * exact answers. Lengths are in radii of the lens or in pixels; the shutter is open for the unit of time.
 */
final class ExactProblems {

    /** A straight edge across the lens. */
    static final ExactProblem ON_LENS = new ExactProblem(
            "edge", "An edge seen through the lens", SampledSpace.LENS, -0.70, "-3/4", 0.25, random -> {
                double angle = 2 * Math.PI * random.nextDouble();
                double cosine = Math.cos(angle);
                double sine = Math.sin(angle);
                double c = random.nextDouble(-0.9, 0.9);
                return new ExactProblem.Instance(
                        position -> cosine * position.lensX + sine * position.lensY < c ? 1 : 0, DiscArea.below(c));
            });

    /** An edge that sweeps over the lens from one side of the pixel to the other. */
    static final ExactProblem ON_LENS_AND_PIXEL = new ExactProblem(
            "edge-in-pixel",
            "An edge seen through the lens and the pixel",
            SampledSpace.LENS_AND_PIXEL,
            -0.57,
            "-5/8",
            0.5,
            random -> {
                double angle = 2 * Math.PI * random.nextDouble();
                double cosine = Math.cos(angle);
                double sine = Math.sin(angle);
                double u = random.nextDouble(0.3, 1.5);
                double v = random.nextDouble(0.3, 1.5);
                double c = random.nextDouble(-0.9, 0.9);
                return new ExactProblem.Instance(
                        position -> cosine * position.lensX
                                                + sine * position.lensY
                                                + u * (position.x - 0.5)
                                                + v * (position.y - 0.5)
                                        < c
                                ? 1
                                : 0,
                        DiscArea.below(c, u, v));
            });

    /** A straight edge in any direction that passes. */
    static final ExactProblem PASSING = new ExactProblem(
            "passing-slanted-edge",
            "A slanted edge passes",
            SampledSpace.TIME_AND_PIXEL,
            -0.62,
            "-2/3",
            0.4,
            random -> {
                double angle = Math.toRadians(random.nextDouble(5, 85));
                double perX = Math.cos(angle);
                double perY = Math.sin(angle);
                double speed = random.nextDouble(2, 20);
                boolean fromRight = random.nextBoolean();
                boolean fromBelow = random.nextBoolean();
                double c = (perX + perY) / 2 + speed * random.nextDouble(0.05, 0.95);
                return new ExactProblem.Instance(
                        position -> perX * (fromRight ? 1 - position.x : position.x)
                                                + perY * (fromBelow ? 1 - position.y : position.y)
                                                + speed * position.moment
                                        < c
                                ? 1
                                : 0,
                        fractionBelow(c, perX, perY, speed));
            });

    /** Those of a wide aperture. */
    static final List<ExactProblem> OF_LENS = List.of(ON_LENS, ON_LENS_AND_PIXEL);

    /** Those of a long exposure. */
    static final List<ExactProblem> OF_EXPOSURE = List.of(PASSING);

    private ExactProblems() {}

    /**
     * The fraction of a box with one corner at 0 in which the sum of the coordinates is below a number: a sum over its
     * corners with alternating signs.
     *
     * @param sides of the box, two or three
     */
    private static double fractionBelow(double height, double... sides) {
        double sum = 0;
        for (int corner = 0; corner < 1 << sides.length; corner++) {
            double from = height;
            for (int side = 0; side < sides.length; side++) {
                from -= (corner >> side & 1) * sides[side];
            }
            double part = 1;
            for (int side = 0; side < sides.length; side++) {
                part *= Math.max(0, from) / sides[side] / (side + 1);
            }
            sum += Integer.bitCount(corner) % 2 == 0 ? part : -part;
        }
        return sum;
    }
}
