package tompkins.study;

import java.util.List;
import java.util.Locale;
import java.util.function.LongFunction;
import java.util.stream.Collectors;

/** The studies that the program can make. Each has a chapter of one page. */
public enum StudyKind {

    /** Where samples lie on the lens, in the pixel and in the exposure time; see {@link SamplingStudy}. */
    APERTURE(seed -> new Joint(List.of(
            SamplingStudy.of("aperture", seed, ExactProblems.OF_LENS, "fig3a", "fig3b"),
            SamplingStudy.of("exposure", seed, ExactProblems.OF_EXPOSURE, "rolling-slit")))),

    /** See {@link AntialiasingStudy}. */
    ANTIALIASING(AntialiasingStudy::of),

    /** Digits that formulas keep, and hits; see {@link PrecisionStudy}, {@link StabilityStudy}, {@link ChordStudy}. */
    PRECISION(seed -> new Joint(List.of(new PrecisionStudy(seed), new StabilityStudy(seed), new ChordStudy(seed)))),

    /** See {@link TreeStudy}. */
    TREE(TreeStudy::new),

    /** See {@link DepthStudy}. */
    DEPTH(seed -> new DepthStudy());

    /**
     * Several studies that answer one question together.
     *
     * @param parts the studies; no two of them have a problem of the same name
     */
    private record Joint(List<Study> parts) implements Study {

        @Override
        public String settings() {
            return parts.stream().map(Study::settings).collect(Collectors.joining("; "));
        }

        @Override
        public List<Trial> trials() {
            return parts.stream().flatMap(part -> part.trials().stream()).toList();
        }

        @Override
        public List<Chart> charts() {
            return parts.stream().flatMap(part -> part.charts().stream()).toList();
        }

        @Override
        public void conclude(List<StudyPoint> all, Conclusion conclusion) {
            for (Study part : parts) {
                conclusion.beginParagraph();
                part.conclude(all, conclusion);
            }
        }
    }

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
