package tompkins.app;

import picocli.CommandLine.Option;
import tompkins.image.ToneCurve;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;

/** Where the samples of a picture lie, and how its light becomes colours. */
final class PictureOptions {

    @Option(names = "--seed", paramLabel = "N", description = "seed for the positions of the samples")
    private Long seed;

    @Option(
            names = "--tone",
            paramLabel = "CURVE",
            completionCandidates = OptionWords.ToneCurves.class,
            description = "tone curve of all pictures but Radiance pictures: ${COMPLETION-CANDIDATES}")
    private ToneCurve toneCurve;

    /** The studio with the seed and the tone curve that were given. */
    Studio applyTo(Studio studio) {
        RenderSettings settings = studio.settings();
        if (seed != null) {
            settings = settings.withSeed(seed);
        }
        if (toneCurve != null) {
            settings = settings.withToneCurve(toneCurve);
        }
        return studio.withSettings(settings);
    }
}
