package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.Function;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;

/**
 * Something that a pixel may see, with the exact answer: how much of it is bright.
 *
 * @param key its name in files
 * @param title of its chart
 * @param space what the samples have to be spread over
 * @param largestSlope with which the error of the program's samples may fall
 * @param theory the slope that theory gives it
 * @param share the largest error of the program's samples, divided by that of random ones
 * @param instances makes cases of the problem
 */
record ExactProblem(
        String key,
        String title,
        SampledSpace space,
        double largestSlope,
        String theory,
        double share,
        Function<SplittableRandom, Instance> instances) {

    /** Number of cases that are worked out. */
    static final int INSTANCES = 60;

    /** The pixels that see a case form a square, so that neighbours in either direction are compared. */
    private static final int SIDE = 4;

    /** Pixels that see the same case. */
    static final int PIXELS_OF_INSTANCE = SIDE * SIDE;

    private static final int INSTANCES_OF_BLOCK = 15;

    /** Something to be integrated. */
    @FunctionalInterface
    interface Integrand {

        /** Its value at a position. */
        double value(Position position);
    }

    /**
     * One case of a problem.
     *
     * @param integrand what is to be integrated
     * @param exact its mean over all positions
     */
    record Instance(Integrand integrand, double exact) {}

    /**
     * The errors of all pixels; those of one case are next to each other.
     *
     * @param seed of the cases
     */
    double[] errors(long seed, Sampler sampler, int samples) {
        double[] errors = new double[INSTANCES * PIXELS_OF_INSTANCE];
        SplittableRandom random = new SplittableRandom(seed);
        SamplePositions positions = new SamplePositions(INSTANCES_OF_BLOCK * PIXELS_OF_INSTANCE);
        Instance[] cases = new Instance[INSTANCES_OF_BLOCK];
        for (int first = 0; first < INSTANCES; first += INSTANCES_OF_BLOCK) {
            positions.clear();
            for (int i = 0; i < INSTANCES_OF_BLOCK; i++) {
                cases[i] = instances.apply(random);
                for (int pixel = 0; pixel < PIXELS_OF_INSTANCE; pixel++) {
                    positions.addPixel(pixel % SIDE, (first + i) * SIDE + pixel / SIDE);
                }
            }
            addErrors(cases, positions, sampler, samples, errors, first * PIXELS_OF_INSTANCE);
        }
        return errors;
    }

    private static void addErrors(
            Instance[] cases, SamplePositions positions, Sampler sampler, int samples, double[] errors, int first) {
        Position position = new Position();
        for (int sample = 0; sample < samples; sample++) {
            sampler.choose(positions, sample);
            for (int i = 0; i < positions.count(); i++) {
                position.goTo(positions, i);
                errors[first + i] += cases[i / PIXELS_OF_INSTANCE].integrand().value(position);
            }
        }
        for (int i = 0; i < positions.count(); i++) {
            errors[first + i] = errors[first + i] / samples - cases[i / PIXELS_OF_INSTANCE].exact();
        }
    }
}
