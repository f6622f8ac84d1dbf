package tompkins.study;

import java.util.List;

/** What a pixel may see through the lens, with the exact answers. */
final class LensProblems {

    /** A straight edge across the lens. */
    static final ExactProblem EDGE = new ExactProblem(
            "edge", "An edge seen through the lens", SampledSpace.LENS, -0.70, "-3/4", 0.25, random -> {
                double angle = 2 * Math.PI * random.nextDouble();
                double cosine = Math.cos(angle);
                double sine = Math.sin(angle);
                double c = random.nextDouble(-0.9, 0.9);
                return new ExactProblem.Instance(
                        position -> cosine * position.lensX + sine * position.lensY < c ? 1 : 0, DiscArea.below(c));
            });

    /** A disc that covers a part of the lens. */
    static final ExactProblem DISC =
            new ExactProblem("disc", "A disc seen through the lens", SampledSpace.LENS, -0.70, "-3/4", 0.25, random -> {
                double angle = 2 * Math.PI * random.nextDouble();
                double distance = random.nextDouble(1);
                double centreX = distance * Math.cos(angle);
                double centreY = distance * Math.sin(angle);
                double radius = random.nextDouble(0.3, 0.9);
                return new ExactProblem.Instance(
                        position -> {
                            double x = position.lensX - centreX;
                            double y = position.lensY - centreY;
                            return x * x + y * y < radius * radius ? 1 : 0;
                        },
                        DiscArea.overlap(distance, radius));
            });

    /** A chequerboard. */
    static final ExactProblem CHEQUER = new ExactProblem(
            "chequer", "A chequerboard seen through the lens", SampledSpace.LENS, -0.70, "-3/4", 0.5, random -> {
                double angle = 2 * Math.PI * random.nextDouble();
                double cosine = Math.cos(angle);
                double sine = Math.sin(angle);
                double side = random.nextDouble(0.5, 1);
                double left = -3 + side * random.nextDouble();
                double bottom = -3 + side * random.nextDouble();
                return new ExactProblem.Instance(
                        position -> {
                            int column = (int) ((cosine * position.lensX + sine * position.lensY - left) / side);
                            int row = (int) ((cosine * position.lensY - sine * position.lensX - bottom) / side);
                            return (column + row) % 2;
                        },
                        chequer(left, bottom, side));
            });

    /** An edge that sweeps over the lens from one side of the pixel to the other. */
    static final ExactProblem SWEEP = new ExactProblem(
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

    /** All of them. */
    static final List<ExactProblem> ALL = List.of(EDGE, DISC, CHEQUER, SWEEP);

    private static final double FAR = 3;

    private LensProblems() {}

    private static double chequer(double left, double bottom, double side) {
        double sum = 0;
        for (int column = 0; left + column * side < FAR; column++) {
            for (int row = 0; bottom + row * side < FAR; row++) {
                if ((column + row) % 2 == 1) {
                    double x = left + column * side;
                    double y = bottom + row * side;
                    sum += DiscArea.corner(x + side, y + side)
                            - DiscArea.corner(x, y + side)
                            - DiscArea.corner(x + side, y)
                            + DiscArea.corner(x, y);
                }
            }
        }
        return sum;
    }
}
