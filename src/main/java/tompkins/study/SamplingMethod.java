package tompkins.study;

import java.util.LinkedHashMap;
import java.util.Map;
import tompkins.camera.PixelSampler;
import tompkins.camera.Sampler;

/** A way to choose positions in the pixel and on the lens, and moments. */
enum SamplingMethod {

    /** Independent random positions; on the lens by rejection, as in Dr TIM. */
    RANDOM("random (as in Dr TIM)", SamplePattern::independent),

    /** One random position in each cell of a grid, on the lens by the concentric map. */
    JITTERED("jittered", SamplePattern::jittered),

    /** Multiples of irrational numbers (Roberts 2018), shifted for each pixel. */
    ADDITIVE("R2", SamplePattern::additive),

    /** The program's own: Sobol points with Owen's scrambling. */
    SOBOL("Sobol (Owen-scrambled)", (seed, samples, space) -> new PixelSampler(seed, space.hasLens(), space.hasTime())),

    /** Halton points, shifted for each pixel. */
    HALTON("Halton", SamplePattern::halton);

    private final String title;
    private final Factory factory;

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

    /** The samplers of all methods, by name. */
    static Map<String, Factory> all() {
        Map<String, Factory> all = new LinkedHashMap<>();
        for (SamplingMethod method : values()) {
            all.put(method.title, method.factory);
        }
        return all;
    }
}
