package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import tompkins.io.BundledScenes;
import tompkins.studio.Studio;

/**
 * Whether samples are better shared evenly or put where they are needed, and whether the error is what was promised.
 *
 * @param compared pinhole photographs on which methods are compared
 * @param promises photographs on which the promised error is compared with the true one
 * @param seed of the first of several runs
 * @param width of the compared photographs in pixels
 * @param referenceSamples samples per pixel of the references of the compared photographs
 */
record AntialiasingStudy(
        Map<String, Studio> compared, PromisedErrors promises, long seed, int width, int referenceSamples)
        implements Study {

    /** The study, as thorough as for the documents. */
    static AntialiasingStudy of(long seed) {
        return new AntialiasingStudy(
                BundledScenes.named("fig1a", "fig2a"), PromisedErrors.ofAllScenes(seed), seed, 144, 4096);
    }

    @Override
    public String settings() {
        return StudyText.of(
                "antialiasing.settings",
                seed,
                seed + PictureStudy.SEEDS - 1,
                width,
                referenceSamples,
                compared.keySet(),
                promises.settings());
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        compared.forEach((name, studio) ->
                trials.addAll(new PictureStudy(name, studio, seed, width, referenceSamples, () -> false).trials(true)));
        trials.addAll(promises.trials());
        return trials;
    }

    @Override
    public List<Chart> charts() {
        List<Chart> charts = new ArrayList<>();
        for (String name : compared.keySet()) {
            charts.add(new Chart(name, name + ", pinhole", Chart.RAYS, Chart.ERROR, true, PictureStudy.ADAPTIVE));
        }
        charts.add(PromisedErrors.chart());
        return charts;
    }

    @Override
    public void conclude(List<StudyPoint> all, Conclusion conclusion) {
        conclusion.say("antialiasing.centre");
        for (String name : compared.keySet()) {
            double centre = error(name, PictureStudy.CENTRE, all);
            double anywhere = error(name, PictureStudy.ANYWHERE, all);
            conclusion.say("antialiasing.centreOf", name, 100 * centre / anywhere);
        }
        conclusion.say("antialiasing.adaptive");
        for (String name : compared.keySet()) {
            double centre = error(name, PictureStudy.CENTRE, all);
            double anywhere = error(name, PictureStudy.ANYWHERE, all);
            conclusion.demand(centre <= anywhere, "antialiasing.centreError", name, anywhere, centre);
            double saving = saving(name, all);
            conclusion.say("antialiasing.adaptiveOf", name, 100 / saving);
            conclusion.demand(saving > 1, "antialiasing.saving", name, saving);
        }
        PromisedErrors.conclude(all, conclusion);
    }

    private static double error(String name, String method, List<StudyPoint> all) {
        return StudyPoint.of(name, method, 1, all).medianError();
    }

    /** How many times fewer rays are needed for the same error, by the law fitted to the same number everywhere. */
    private static double saving(String name, List<StudyPoint> all) {
        PowerLaw fixed = PowerLaw.ofError(StudyPoint.of(name, PictureStudy.FIXED, all), StudyPoint::rays);
        List<StudyPoint> adaptive = StudyPoint.of(name, PictureStudy.ADAPTIVE, all);
        double log = 0;
        for (StudyPoint point : adaptive) {
            double needed = Math.pow(point.medianError() / fixed.factor(), 1 / fixed.slope());
            log += Math.log(needed / point.rays()) / adaptive.size();
        }
        return Math.exp(log);
    }
}
