package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.Function;

/** What a pixel may see through the lens, with the exact answer. */
enum ExactProblem {

    /** A straight edge across the lens. */
    EDGE("edge", "An edge seen through the lens", SampledSpace.LENS, random -> {
        double angle = 2 * Math.PI * random.nextDouble();
        double cosine = Math.cos(angle);
        double sine = Math.sin(angle);
        double c = random.nextDouble(-0.9, 0.9);
        return new Instance(place -> cosine * place.lensX + sine * place.lensY < c ? 1 : 0, DiscArea.below(c));
    }),

    /** A disc that covers a part of the lens. */
    DISC("disc", "A disc seen through the lens", SampledSpace.LENS, random -> {
        double angle = 2 * Math.PI * random.nextDouble();
        double distance = random.nextDouble(1);
        double centreX = distance * Math.cos(angle);
        double centreY = distance * Math.sin(angle);
        double radius = random.nextDouble(0.3, 0.9);
        return new Instance(
                place -> {
                    double x = place.lensX - centreX;
                    double y = place.lensY - centreY;
                    return x * x + y * y < radius * radius ? 1 : 0;
                },
                DiscArea.overlap(distance, radius));
    }),

    /** A chequerboard. */
    CHEQUER("chequer", "A chequerboard seen through the lens", SampledSpace.LENS, random -> {
        double angle = 2 * Math.PI * random.nextDouble();
        double cosine = Math.cos(angle);
        double sine = Math.sin(angle);
        double side = random.nextDouble(0.5, 1);
        double left = -3 + side * random.nextDouble();
        double bottom = -3 + side * random.nextDouble();
        return new Instance(
                place -> {
                    int column = (int) ((cosine * place.lensX + sine * place.lensY - left) / side);
                    int row = (int) ((cosine * place.lensY - sine * place.lensX - bottom) / side);
                    return (column + row) % 2;
                },
                chequer(left, bottom, side));
    }),

    /** An edge that sweeps over the lens from one side of the pixel to the other. */
    SWEEP("edge-in-pixel", "An edge seen through the lens and the pixel", SampledSpace.LENS_AND_PIXEL, random -> {
        double angle = 2 * Math.PI * random.nextDouble();
        double cosine = Math.cos(angle);
        double sine = Math.sin(angle);
        double u = random.nextDouble(0.3, 1.5);
        double v = random.nextDouble(0.3, 1.5);
        double c = random.nextDouble(-0.9, 0.9);
        return new Instance(
                place -> cosine * place.lensX + sine * place.lensY + u * (place.x - 0.5) + v * (place.y - 0.5) < c
                        ? 1
                        : 0,
                DiscArea.below(c, u, v));
    });

    /** Something to be integrated. */
    @FunctionalInterface
    interface Integrand {

        /** Its value at the place where a pattern is. */
        double value(SamplePattern place);
    }

    /**
     * One case of a problem.
     *
     * @param integrand what is to be integrated
     * @param exact its mean over lens and pixel
     */
    record Instance(Integrand integrand, double exact) {}

    private static final double FAR = 3;

    private final String key;
    private final String title;
    private final SampledSpace space;
    private final Function<SplittableRandom, Instance> instances;

    ExactProblem(String key, String title, SampledSpace space, Function<SplittableRandom, Instance> instances) {
        this.key = key;
        this.title = title;
        this.space = space;
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

    SampledSpace space() {
        return space;
    }

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
