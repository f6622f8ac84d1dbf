package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.Function;
import tompkins.study.ExactProblem.Instance;

/**
 * What may pass a pixel in uniform motion while the shutter is open, with the exact answer. Lengths are in pixels; the
 * shutter is open for the unit of time.
 */
enum MotionProblem {

    /** A straight edge along the rows or the columns, which it crosses. */
    EDGE("edge", "An edge passes, along rows or columns", -0.70, "-3/4", random -> {
        double speed = random.nextDouble(2, 20);
        double c = 0.5 + speed * random.nextDouble(0.05, 0.95);
        boolean alongRows = random.nextBoolean();
        return new Instance(
                place -> (alongRows ? place.y : place.x) + speed * place.moment < c ? 1 : 0,
                (square(c) - square(c - 1) - square(c - speed) + square(c - 1 - speed)) / speed);
    }),

    /** A straight edge in any direction. */
    SLANTED("slanted-edge", "A slanted edge passes", -0.62, "-2/3", random -> {
        Slope slope = new Slope(random);
        double c = slope.middle() + slope.speed() * random.nextDouble(0.05, 0.95);
        return new Instance(place -> slope.at(place) < c ? 1 : 0, slope.shareBelow(c));
    }),

    /** A bright slit in any direction. */
    SLIT("slit", "A slanted slit passes", -0.62, "-2/3", random -> {
        Slope slope = new Slope(random);
        double width = random.nextDouble(0.5, 3);
        double c = slope.middle() + slope.speed() * random.nextDouble(0.05, 0.95);
        return new Instance(
                place -> {
                    double height = slope.at(place);
                    return height >= c - width && height < c ? 1 : 0;
                },
                slope.shareBelow(c) - slope.shareBelow(c - width));
    }),

    /** A bright disc that passes along the rows or the columns. */
    DISC("disc", "A small disc passes", -0.62, "-2/3", random -> {
        double radius = random.nextDouble(0.5, 2);
        double beside = 0.5 + radius * random.nextDouble(-0.9, 0.9);
        double speed = 2 * radius + 1 + random.nextDouble(1, 15);
        double start = -radius - (speed - 2 * radius - 1) * random.nextDouble();
        boolean alongRows = random.nextBoolean();
        return new Instance(
                place -> {
                    double ahead = (alongRows ? place.x : place.y) - start - speed * place.moment;
                    double aside = (alongRows ? place.y : place.x) - beside;
                    return ahead * ahead + aside * aside < radius * radius ? 1 : 0;
                },
                (halfDisc(1 - beside, radius) - halfDisc(-beside, radius)) / speed);
    });

    /** The height of a place over the line of an edge, which grows with time. */
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

        double at(SamplePattern place) {
            return perX * (fromRight ? 1 - place.x : place.x)
                    + perY * (fromBelow ? 1 - place.y : place.y)
                    + speed * place.moment;
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

    private final String key;
    private final String title;
    private final double largestSlope;
    private final String theory;
    private final Function<SplittableRandom, Instance> instances;

    MotionProblem(
            String key,
            String title,
            double largestSlope,
            String theory,
            Function<SplittableRandom, Instance> instances) {
        this.key = key;
        this.title = title;
        this.largestSlope = largestSlope;
        this.theory = theory;
        this.instances = instances;
    }

    Instance instance(SplittableRandom random) {
        return instances.apply(random);
    }

    String key() {
        return key;
    }

    String title() {
        return title;
    }

    /** The largest slope that the program's places may have. */
    double largestSlope() {
        return largestSlope;
    }

    /** The slope that theory gives them. */
    String theory() {
        return theory;
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
