package tompkins.study;

import java.util.List;
import java.util.Map;
import tompkins.studio.Studio;

/** How best to choose the moments of samples while the shutter stays open. */
final class ExposureStudy extends SamplingStudy {

    /** The study, of photographs with an exposure time; for the rest see {@link SamplingStudy}. */
    ExposureStudy(Map<String, Studio> studios, Comparison comparison) {
        super(studios, comparison, ExactProblems.OF_EXPOSURE, "long exposure");
    }

    @Override
    public void conclude(List<Measurement> all, Conclusion conclusion) {
        conclusion.say(
                "exposure.answer",
                law(ExactProblems.PASSING, PROGRAM, all).slope(),
                law(ExactProblems.PASSING_SLANTED, PROGRAM, all).slope(),
                shareOfRandom(ExactProblems.PASSING, all),
                shareOfRandom(ExactProblems.PASSING_SLANTED, all));
        super.conclude(all, conclusion);
    }
}
