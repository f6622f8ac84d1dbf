package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.IntStream;
import tompkins.study.ExactProblem.Instance;

/** Methods at work on problems with an exact answer. */
final class ExactTrials {

    static final int INSTANCES = 60;

    /** The pixels of an instance form a square, so that neighbours in either direction are compared. */
    private static final int SIDE_OF_INSTANCE = 4;

    static final int PIXELS_OF_INSTANCE = SIDE_OF_INSTANCE * SIDE_OF_INSTANCE;

    private final long seed;
    private final int mostSamples;
    private final int repeats;

    /**
     * Trials.
     *
     * @param mostSamples the largest number of samples per pixel; a power of 4
     * @param repeats runs of each
     */
    ExactTrials(long seed, int mostSamples, int repeats) {
        this.seed = seed;
        this.mostSamples = mostSamples;
        this.repeats = repeats;
    }

    /** Numbers of samples that are measured. */
    IntStream counts() {
        return IntStream.iterate(4, samples -> samples <= mostSamples, samples -> 4 * samples);
    }

    /** A method's time and error. */
    Figures figures(
            Function<SplittableRandom, Instance> problem,
            SampledSpace space,
            SamplingMethod.Factory factory,
            int samples) {
        Stopwatch.warmUp(() -> errors(problem, factory.pattern(0, samples, space), samples));
        List<Figures> runs = new ArrayList<>();
        for (int run = 0; run < repeats; run++) {
            SamplePattern pattern = factory.pattern(seed + run, samples, space);
            double[][] errors = new double[1][];
            double seconds = Stopwatch.seconds(() -> errors[0] = errors(problem, pattern, samples));
            runs.add(Figures.of((double) samples * errors[0].length, seconds, ErrorNorm.of(errors[0]), 0));
        }
        return Figures.of(runs);
    }

    /** The errors of all pixels; those of one instance are next to each other. */
    double[] errors(Function<SplittableRandom, Instance> problem, SamplePattern pattern, int samples) {
        double[] errors = new double[INSTANCES * PIXELS_OF_INSTANCE];
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < INSTANCES; i++) {
            Instance instance = problem.apply(random);
            for (int j = 0; j < PIXELS_OF_INSTANCE; j++) {
                pattern.startPixel(j % SIDE_OF_INSTANCE, i * SIDE_OF_INSTANCE + j / SIDE_OF_INSTANCE);
                double sum = 0;
                double weights = 0;
                for (int sample = 0; sample < samples; sample++) {
                    pattern.goTo(sample);
                    sum += pattern.weight * instance.integrand().value(pattern);
                    weights += pattern.weight;
                }
                errors[i * PIXELS_OF_INSTANCE + j] = sum / weights - instance.exact();
            }
        }
        return errors;
    }
}
