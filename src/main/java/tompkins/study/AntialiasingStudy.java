package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import tompkins.studio.Studio;

/**
 * Whether samples are better shared evenly or put where they are needed, and whether the error is what was promised.
 *
 * @param compared pinhole photographs on which methods are compared
 * @param promised photographs on which the promised error is compared with the true one
 * @param sparse photographs with sparse light, of which the same is asked
 * @param width width of the compared photographs in pixels; the promised ones have a third of it
 * @param referenceSamples samples per pixel of the references of the compared photographs; those of the promised ones
 *     begin with a quarter and have as many as it takes
 */
record AntialiasingStudy(
        Map<String, Studio> compared,
        Map<String, Studio> promised,
        Map<String, Studio> sparse,
        long seed,
        int width,
        int referenceSamples)
        implements Study {

    private PromisedErrors promises() {
        return new PromisedErrors(promised, sparse, seed, promisedWidth(), referenceSamples / 4);
    }

    private int promisedWidth() {
        return width / 3;
    }

    @Override
    public String settings() {
        return "seeds " + seed + " to " + (seed + PictureStudy.SEEDS - 1) + ", width " + width + " and "
                + promisedWidth()
                + ", references " + referenceSamples + " samples or as many as it takes, scenes "
                + StudySetup.settings(compared) + ", " + StudySetup.settings(promised) + " and " + sparse.keySet();
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        compared.forEach((name, studio) ->
                trials.addAll(new PictureStudy(name, studio, seed, width, referenceSamples, () -> false).trials(true)));
        trials.addAll(promises().trials());
        return trials;
    }

    @Override
    public List<Chart> charts() {
        List<Chart> charts = new ArrayList<>();
        compared.forEach((name, studio) -> charts.add(new Chart(
                        name,
                        name + (studio.camera().hasWideAperture() ? ", wide aperture" : ", pinhole"),
                        Chart.across("rays", Measurement::rays),
                        Chart.ERROR,
                        true)
                .withOwn(PictureStudy.ADAPTIVE)));
        if (!promised.isEmpty()) {
            charts.add(PromisedErrors.chart());
        }
        return charts;
    }

    @Override
    public String answer(List<Measurement> all) {
        StringBuilder text = new StringBuilder(StudyText.of("antialiasing.centre"));
        for (String name : compared.keySet()) {
            for (Measurement centre : Measurement.of(name, PictureStudy.CENTRE, all)) {
                double ratio = centre.medianError() / anywhere(name, all);
                text.append(StudyText.of("antialiasing.centreOf", name, 100 * ratio));
            }
        }
        text.append(StudyText.of("antialiasing.adaptive"));
        for (String name : compared.keySet()) {
            text.append(StudyText.of("antialiasing.adaptiveOf", name, 100 / saving(name, all)));
        }
        if (!promised.isEmpty()) {
            text.append(StudyText.of("antialiasing.promise", Math.floor(100 * PromisedErrors.share(all))));
        }
        return text.toString();
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        List<Finding> findings = new ArrayList<>();
        for (String name : compared.keySet()) {
            for (Measurement centre : Measurement.of(name, PictureStudy.CENTRE, all)) {
                double anywhere = anywhere(name, all);
                findings.add(Finding.of(
                        centre.medianError() <= anywhere,
                        name + ": error of one sample in the centre of each pixel",
                        Finding.text("at most %.3g, that of one sample anywhere in it", anywhere),
                        "%.3g",
                        centre.medianError()));
            }
            double saving = saving(name, all);
            findings.add(Finding.of(
                    saving > 1,
                    name + ": rays of the same number everywhere, divided by those of `--error` for the same error",
                    "above 1",
                    "%.2f",
                    saving));
        }
        findings.addAll(PromisedErrors.findings(all));
        return findings;
    }

    private static double anywhere(String name, List<Measurement> all) {
        return Measurement.of(name, PictureStudy.ANYWHERE, 1, all).medianError();
    }

    /** How many times fewer rays are needed for the same error, by the law fitted to the same number everywhere. */
    private static double saving(String name, List<Measurement> all) {
        PowerLaw fixed = PowerLaw.ofError(Measurement.of(name, PictureStudy.FIXED, all), Measurement::rays);
        List<Measurement> adaptive = Measurement.of(name, PictureStudy.ADAPTIVE, all);
        double log = 0;
        for (Measurement point : adaptive) {
            double needed = Math.pow(point.medianError() / fixed.factor(), 1 / fixed.slope());
            log += Math.log(needed / point.rays()) / adaptive.size();
        }
        return Math.exp(log);
    }
}
