package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
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
 * @param ratio the largest error of the program's samples, divided by that of random ones
 * @param instances makes cases of the problem
 */
record ExactProblem(
        String key,
        String title,
        SampledSpace space,
        double largestSlope,
        String theory,
        double ratio,
        Function<SplittableRandom, Instance> instances) {

    /** Number of cases that are worked out. */
    static final int INSTANCES = 60;

    /** The pixels that see a case form a square, so that neighbours in either direction are compared. */
    private static final int SIDE = 4;

    /** Pixels that see the same case. */
    static final int PIXELS_OF_INSTANCE = SIDE * SIDE;

    /**
     * One case of a problem.
     *
     * @param integrand what is to be integrated
     * @param exact its mean over all positions
     */
    record Instance(ToDoubleFunction<Position> integrand, double exact) {}

    /**
     * The errors of all pixels; those of one case are next to each other.
     *
     * @param seed of the cases
     */
    double[] errors(long seed, Sampler sampler, int samples) {
        double[] errors = new double[INSTANCES * PIXELS_OF_INSTANCE];
        SplittableRandom random = new SplittableRandom(seed);
        SamplePositions positions = new SamplePositions(PIXELS_OF_INSTANCE);
        Position position = new Position();
        for (int first = 0; first < errors.length; first += PIXELS_OF_INSTANCE) {
            Instance instance = instances.apply(random);
            positions.clear();
            for (int pixel = 0; pixel < PIXELS_OF_INSTANCE; pixel++) {
                positions.addPixel(pixel % SIDE, (first + pixel) / SIDE);
            }
            for (int sample = 0; sample < samples; sample++) {
                sampler.choose(positions, sample);
                for (int i = 0; i < PIXELS_OF_INSTANCE; i++) {
                    position.goTo(positions, i);
                    errors[first + i] += instance.integrand.applyAsDouble(position);
                }
            }
            for (int i = first; i < first + PIXELS_OF_INSTANCE; i++) {
                errors[i] = errors[i] / samples - instance.exact;
            }
        }
        return errors;
    }
}
