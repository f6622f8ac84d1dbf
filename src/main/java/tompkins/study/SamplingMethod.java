package tompkins.study;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.BiFunction;
import tompkins.camera.PixelSampler;
import tompkins.camera.Sampler;

/** A way to choose positions in the pixel and on the lens, and moments. */
enum SamplingMethod {

    /** Independent random positions; on the lens by rejection, as in Dr TIM. */
    RANDOM("random (as in Dr TIM)", (samples, space) -> SamplePatterns.independent(space)),

    /** One random position in each cell of a grid, on the lens by the concentric map. */
    JITTERED("jittered", SamplePatterns::jittered),

    /** Multiples of irrational numbers (Roberts 2018), shifted for each pixel. */
    ADDITIVE("R2", SamplePatterns::additive),

    /** The program's own: Sobol points with Owen's scrambling. */
    SOBOL("Sobol (Owen-scrambled)", (seed, samples, space) -> new PixelSampler(seed, space.hasLens(), space.hasTime())),

    /** Halton points, shifted for each pixel. */
    HALTON("Halton", SamplePatterns::halton);

    private final String title;
    private final Factory factory;

    SamplingMethod(String title, BiFunction<Integer, SampledSpace, SamplePattern.Pixels> pixels) {
        this(title, (seed, samples, space) -> new SamplePattern(seed, pixels.apply(samples, space)));
    }

    SamplingMethod(String title, Factory factory) {
        this.title = title;
        this.factory = factory;
    }

    /** The name in charts. */
    String title() {
        return title;
    }

    /** Makes its samplers. */
    Factory factory() {
        return factory;
    }

    /** Makes the samplers of a method. */
    @FunctionalInterface
    interface Factory {

        /**
         * A sampler for one thread.
         *
         * @param samples samples per pixel
         * @param space what the samples have to be spread over
         */
        Sampler sampler(long seed, int samples, SampledSpace space);
    }

    /** The comparison of all methods, as thorough as for the documents. */
    static SamplingStudy.Comparison all(long seed) {
        Map<String, Factory> all = new LinkedHashMap<>();
        for (SamplingMethod method : values()) {
            all.put(method.title, method.factory);
        }
        return new SamplingStudy.Comparison(seed, 4096, 5, all);
    }
}
