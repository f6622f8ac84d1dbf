package tompkins.study;

/** A way to choose places in the pixel and on the lens. */
enum SamplingMethod {

    /** Independent random places; on the lens by rejection, as in Dr TIM. */
    RANDOM("random (as in Dr TIM)") {
        @Override
        SamplePattern pattern(long seed, int samples, boolean pixelToo) {
            return new RandomPattern(seed, pixelToo);
        }
    },

    /** One random place in each cell of a grid, on the lens by the concentric map. */
    JITTERED("jittered") {
        @Override
        SamplePattern pattern(long seed, int samples, boolean pixelToo) {
            return new JitteredPattern(seed, samples, pixelToo);
        }
    },

    /** Multiples of irrational numbers (Roberts 2018), shifted for each pixel. */
    ADDITIVE("R2") {
        @Override
        SamplePattern pattern(long seed, int samples, boolean pixelToo) {
            return ShiftedPattern.additive(seed, samples, pixelToo);
        }
    },

    /** The program's own: Sobol points with Owen's scrambling. */
    SOBOL("Sobol, Owen-scrambled") {
        @Override
        SamplePattern pattern(long seed, int samples, boolean pixelToo) {
            return new ProgramPattern(seed, pixelToo);
        }
    },

    /** Halton points, shifted for each pixel. */
    HALTON("Halton") {
        @Override
        SamplePattern pattern(long seed, int samples, boolean pixelToo) {
            return ShiftedPattern.halton(seed, samples, pixelToo);
        }
    },

    /** A sunflower spiral, turned for each pixel. */
    VOGEL("Vogel spiral") {
        @Override
        SamplePattern pattern(long seed, int samples, boolean pixelToo) {
            return DiscPattern.vogel(seed, samples, pixelToo);
        }
    },

    /** Gauss's rule in the square of the radius times equal angles, turned for each pixel. */
    GAUSS("Gauss on the disc") {
        @Override
        SamplePattern pattern(long seed, int samples, boolean pixelToo) {
            return DiscPattern.gauss(seed, samples, pixelToo);
        }
    };

    private final String title;

    SamplingMethod(String title) {
        this.title = title;
    }

    /** The name in charts. */
    String title() {
        return title;
    }

    /** A method that can be measured like those of this list; tests break samplers through it. */
    interface Factory {

        /**
         * A pattern for one thread.
         *
         * @param samples samples per pixel
         * @param pixelToo whether the place in the pixel varies too, or stays in its centre
         */
        SamplePattern pattern(long seed, int samples, boolean pixelToo);
    }

    abstract SamplePattern pattern(long seed, int samples, boolean pixelToo);
}
