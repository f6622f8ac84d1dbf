package tompkins.app;

import picocli.CommandLine.Option;
import tompkins.property.InvalidPropertyException;
import tompkins.render.Quality;
import tompkins.studio.Studio;

/** How good a picture has to be, as a wish. Without one it gets the samples that its scene says. */
final class QualityOptions {

    @Option(
            names = "--error",
            arity = "0..1",
            fallbackValue = "0.002",
            paramLabel = "E",
            description =
                    "takes samples where they are needed until the root mean square error, in linear light, is E; alone"
                            + " it means ${FALLBACK-VALUE}, half a step of an 8-bit picture")
    private Double error;

    @Option(names = "--seconds", paramLabel = "S", description = "takes samples where they help most, for S seconds")
    private Double seconds;

    /** The wish, or what the studio says if there is none. */
    Quality of(Studio studio) {
        try {
            if (error != null) {
                return new Quality.TargetError(error);
            }
            return seconds != null
                    ? new Quality.TimeLimit(seconds)
                    : new Quality.Samples(studio.settings().samples());
        } catch (InvalidPropertyException invalid) {
            throw new MistakeException("option for " + invalid.getMessage());
        }
    }
}
