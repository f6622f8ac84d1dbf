package tompkins.app;

import picocli.CommandLine.Option;
import tompkins.property.Require;
import tompkins.render.Quality;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;

/** How good a picture has to be, as a scene can say it; one wish at most may be given. */
class QualityWish {

    @Option(names = "--samples", paramLabel = "N", description = "takes N samples per pixel, 1 or more")
    private Long samples;

    @Option(
            names = "--error",
            arity = "0..1",
            fallbackValue = "0.002",
            paramLabel = "E",
            description = "takes samples where they are needed until the root mean square error, in linear light, is E;"
                    + " alone it means ${FALLBACK-VALUE}, half a step of an 8-bit picture")
    private Double error;

    /** The studio with the samples or the error that were given. */
    final Studio applyTo(Studio studio) {
        RenderSettings settings = studio.settings();
        if (samples != null) {
            return studio.withSettings(MistakeException.inOption(
                    "--samples",
                    () -> settings.withSamples(Require.within("samples", samples, 1, RenderSettings.MOST_SAMPLES))));
        }
        if (error != null) {
            // 0 has a meaning in a scene, but cannot be asked for as an error
            return studio.withSettings(MistakeException.inOption(
                    "--error", () -> settings.withTargetError(new Quality.TargetError(error).rootMeanSquare())));
        }
        return studio;
    }
}
