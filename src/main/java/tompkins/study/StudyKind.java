package tompkins.study;

import java.util.Locale;
import java.util.function.Function;

/** The studies that the program can make. */
public enum StudyKind {

    /** See {@link ApertureStudy}. */
    APERTURE(setup ->
            new ApertureStudy(setup.studios("fig3a", "fig3b"), SamplingMethod.comparison(setup, SamplingMethod.all()))),

    /** See {@link ExposureStudy}. */
    EXPOSURE(setup -> new ExposureStudy(
            setup.studios("rolling-slit"), SamplingMethod.comparison(setup, SamplingMethod.inTime()))),

    /** See {@link AntialiasingStudy}. */
    ANTIALIASING(AntialiasingStudy::of),

    /** See {@link PrecisionStudy}. */
    PRECISION(setup -> new PrecisionStudy(setup.seed())),

    /** See {@link TreeStudy}. */
    TREE(setup -> new TreeStudy(setup.seed(), 1_000_000, 25)),

    /** See {@link DepthStudy}. */
    DEPTH(setup -> new DepthStudy()),

    /** See {@link PreviewStudy}. */
    PREVIEW(setup -> new PreviewStudy(setup.studios("fig1a", "fig1b"))),

    /** See {@link StabilityStudy}. */
    STABILITY(setup -> new StabilityStudy(setup.seed()));

    private final Function<StudySetup, Study> study;

    StudyKind(Function<StudySetup, Study> study) {
        this.study = study;
    }

    /** Prepares the study. */
    public Study study(StudySetup setup) {
        return study.apply(setup);
    }

    /** Whether a user's scene can be measured. */
    public boolean takesScene() {
        return this == APERTURE || this == EXPOSURE || this == ANTIALIASING || this == PREVIEW;
    }

    /** The name on the command line and of the files. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
