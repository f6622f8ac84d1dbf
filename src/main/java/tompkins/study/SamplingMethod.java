package tompkins.study;

import java.util.LinkedHashMap;
import java.util.Map;

/** A way to choose places in the pixel and on the lens. */
enum SamplingMethod {

    /** Independent random places; on the lens by rejection, as in Dr TIM. */
    RANDOM("random (as in Dr TIM)", (seed, samples, pixelToo) -> new RandomPattern(seed, pixelToo)),

    /** One random place in each cell of a grid, on the lens by the concentric map. */
    JITTERED("jittered", JitteredPattern::new),

    /** Multiples of irrational numbers (Roberts 2018), shifted for each pixel. */
    ADDITIVE("R2", ShiftedPattern::additive),

    /** The program's own: Sobol points with Owen's scrambling. */
    SOBOL("Sobol, Owen-scrambled", (seed, samples, pixelToo) -> new ProgramPattern(seed, pixelToo)),

    /** Halton points, shifted for each pixel. */
    HALTON("Halton", ShiftedPattern::halton),

    /** A sunflower spiral, turned for each pixel. */
    VOGEL("Vogel spiral", DiscPattern::vogel),

    /** Gauss's rule in the square of the radius times equal angles, turned for each pixel. */
    GAUSS("Gauss on the disc", DiscPattern::gauss);

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

    /** Makes its patterns. */
    Factory factory() {
        return factory;
    }

    /** Makes the patterns of a method. */
    @FunctionalInterface
    interface Factory {

        /**
         * A pattern for one thread.
         *
         * @param samples samples per pixel
         * @param pixelToo whether the place in the pixel varies too, or stays in its centre
         */
        SamplePattern pattern(long seed, int samples, boolean pixelToo);
    }

    /** All methods, by title. */
    static Map<String, Factory> all() {
        Map<String, Factory> all = new LinkedHashMap<>();
        for (SamplingMethod method : values()) {
            all.put(method.title, method.factory);
        }
        return all;
    }
}
