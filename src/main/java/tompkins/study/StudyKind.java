package tompkins.study;

import java.util.List;
import java.util.Locale;
import java.util.function.LongFunction;

/** The studies that the program can make. Each has a chapter of one page. */
public enum StudyKind {

    /** Where samples lie on the lens, in the pixel and in the exposure time; see {@link SamplingStudy}. */
    APERTURE(seed -> new JointStudy(List.of(
            SamplingStudy.of("aperture", seed, ExactProblems.OF_LENS, "fig3a", "fig3b"),
            SamplingStudy.of("exposure", seed, ExactProblems.OF_EXPOSURE, "rolling-slit")))),

    /** See {@link AntialiasingStudy}. */
    ANTIALIASING(AntialiasingStudy::of),

    /** Digits that formulas keep, and hits; see {@link PrecisionStudy}, {@link StabilityStudy}, {@link ChordStudy}. */
    PRECISION(seed ->
            new JointStudy(List.of(new PrecisionStudy(seed), new StabilityStudy(seed), new ChordStudy(seed, 200_000)))),

    /** See {@link TreeStudy}. */
    TREE(seed -> new TreeStudy(seed, 1_000_000, 25)),

    /** See {@link DepthStudy}. */
    DEPTH(seed -> new DepthStudy());

    private final LongFunction<Study> study;

    StudyKind(LongFunction<Study> study) {
        this.study = study;
    }

    /**
     * Prepares the study.
     *
     * @param seed of everything that is random
     */
    public Study study(long seed) {
        return study.apply(seed);
    }

    /** The name on the command line and of the files. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
