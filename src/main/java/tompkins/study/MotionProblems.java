package tompkins.study;

import java.util.List;
import java.util.SplittableRandom;

/**
 * What may pass a pixel in uniform motion while the shutter is open, with the exact answers. Lengths are in pixels; the
 * shutter is open for the unit of time.
 */
final class MotionProblems {

    /** A straight edge along the rows or the columns, which it crosses. */
    static final ExactProblem EDGE = new ExactProblem(
            "edge",
            "An edge passes, along rows or columns",
            SampledSpace.TIME_AND_PIXEL,
            -0.70,
            "-3/4",
            0.4,
            random -> {
                double speed = random.nextDouble(2, 20);
                double c = 0.5 + speed * random.nextDouble(0.05, 0.95);
                boolean alongRows = random.nextBoolean();
                return new ExactProblem.Instance(
                        position -> (alongRows ? position.y : position.x) + speed * position.moment < c ? 1 : 0,
                        (square(c) - square(c - 1) - square(c - speed) + square(c - 1 - speed)) / speed);
            });

    /** A straight edge in any direction. */
    static final ExactProblem SLANTED = new ExactProblem(
            "slanted-edge", "A slanted edge passes", SampledSpace.TIME_AND_PIXEL, -0.62, "-2/3", 0.4, random -> {
                Slope slope = new Slope(random);
                double c = slope.middle() + slope.speed() * random.nextDouble(0.05, 0.95);
                return new ExactProblem.Instance(position -> slope.at(position) < c ? 1 : 0, slope.shareBelow(c));
            });

    /** A bright slit in any direction. */
    static final ExactProblem SLIT = new ExactProblem(
            "slit", "A slanted slit passes", SampledSpace.TIME_AND_PIXEL, -0.62, "-2/3", 0.4, random -> {
                Slope slope = new Slope(random);
                double width = random.nextDouble(0.5, 3);
                double c = slope.middle() + slope.speed() * random.nextDouble(0.05, 0.95);
                return new ExactProblem.Instance(
                        position -> {
                            double height = slope.at(position);
                            return height >= c - width && height < c ? 1 : 0;
                        },
                        slope.shareBelow(c) - slope.shareBelow(c - width));
            });

    /** A bright disc that passes along the rows or the columns. */
    static final ExactProblem DISC =
            new ExactProblem("disc", "A small disc passes", SampledSpace.TIME_AND_PIXEL, -0.62, "-2/3", 0.4, random -> {
                double radius = random.nextDouble(0.5, 2);
                double beside = 0.5 + radius * random.nextDouble(-0.9, 0.9);
                double speed = 2 * radius + 1 + random.nextDouble(1, 15);
                double start = -radius - (speed - 2 * radius - 1) * random.nextDouble();
                boolean alongRows = random.nextBoolean();
                return new ExactProblem.Instance(
                        position -> {
                            double ahead = (alongRows ? position.x : position.y) - start - speed * position.moment;
                            double aside = (alongRows ? position.y : position.x) - beside;
                            return ahead * ahead + aside * aside < radius * radius ? 1 : 0;
                        },
                        (halfDisc(1 - beside, radius) - halfDisc(-beside, radius)) / speed);
            });

    /** All of them. */
    static final List<ExactProblem> ALL = List.of(EDGE, SLANTED, SLIT, DISC);

    private MotionProblems() {}

    /** The height of a position over the line of an edge, which grows with time. */
    private record Slope(double perX, double perY, double speed, boolean fromRight, boolean fromBelow) {

        Slope(SplittableRandom random) {
            this(random, Math.toRadians(random.nextDouble(5, 85)));
        }

        private Slope(SplittableRandom random, double angle) {
            this(
                    Math.cos(angle),
                    Math.sin(angle),
                    random.nextDouble(2, 20),
                    random.nextBoolean(),
                    random.nextBoolean());
        }

        double at(Position position) {
            return perX * (fromRight ? 1 - position.x : position.x)
                    + perY * (fromBelow ? 1 - position.y : position.y)
                    + speed * position.moment;
        }

        double middle() {
            return (perX + perY) / 2;
        }

        /**
         * The share of pixel and time in which the height is below a number: a sum over the corners of a box with
         * alternating signs.
         */
        double shareBelow(double height) {
            double sum = 0;
            for (int corner = 0; corner < 8; corner++) {
                double from = height
                        - (corner % 2 == 1 ? perX : 0)
                        - (corner / 2 % 2 == 1 ? perY : 0)
                        - (corner / 4 == 1 ? speed : 0);
                sum += (Integer.bitCount(corner) % 2 == 0 ? 1 : -1) * cube(from);
            }
            return sum / (perX * perY * speed);
        }
    }

    private static double square(double from) {
        return from <= 0 ? 0 : from * from / 2;
    }

    private static double cube(double from) {
        return from <= 0 ? 0 : from * from * from / 6;
    }

    /** The integral of the chord 2 sqrt(r^2 - u^2) up to u. */
    private static double halfDisc(double upTo, double radius) {
        double u = Math.max(-radius, Math.min(radius, upTo));
        return u * Math.sqrt(radius * radius - u * u) + radius * radius * Math.asin(u / radius);
    }
}
