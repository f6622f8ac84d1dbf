package tompkins.study;

import java.util.List;
import java.util.Map;
import tompkins.studio.Studio;

/** How best to choose the moments of samples while the shutter stays open. */
final class ExposureStudy extends SamplingStudy {

    /** The study, of photographs with an exposure time; for the rest see {@link SamplingStudy}. */
    ExposureStudy(Map<String, Studio> studios, Comparison comparison) {
        super(studios, comparison, MotionProblems.ALL, "long exposure");
    }

    @Override
    public String question() {
        return "While the shutter stays open, each sample of a pixel has a moment of its own. How should the moments be"
                + " chosen, beside the places in the pixel? Each method works out for how much of the exposure a pixel sees a"
                + " bright edge, slit or disc in uniform motion, where the answer is known exactly, and the light of pixels of"
                + " photographs with a long exposure.";
    }

    @Override
    public String answer(List<Measurement> all) {
        return Finding.text(
                        "Time is one more dimension of the program's Sobol points; a pinhole gives it the first, an aperture the fourth."
                                + " At an edge that passes along rows or columns the error falls as the number of samples to the power"
                                + " %.2f, as it does at an edge in a wide aperture, and at a slanted one to the power %.2f: pixel and time"
                                + " have three dimensions, and places in three dimensions cannot do better than -2/3 for edges in all"
                                + " directions. Random moments keep to -1/2. With 256 samples the program's points err by %.2f times what"
                                + " random ones do at the edge, and by %.2f times that at the slit.",
                        law(MotionProblems.EDGE, comparison().program(), all).slope(),
                        law(MotionProblems.SLANTED, comparison().program(), all).slope(),
                        shareOfRandom(MotionProblems.EDGE, all),
                        shareOfRandom(MotionProblems.SLIT, all))
                + timesInPhotographs(all);
    }
}
