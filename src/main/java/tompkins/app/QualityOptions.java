package tompkins.app;

import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import tompkins.property.Require;
import tompkins.render.Quality;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;

/** How good a picture has to be, as one wish, and where its samples lie. */
final class QualityOptions {

    /** The wishes, of which one at most may be given. */
    private static final class Wish {

        @Option(names = "--samples", paramLabel = "N", description = "takes N samples per pixel, 1 or more")
        private Long samples;

        @Option(
                names = "--error",
                arity = "0..1",
                fallbackValue = "0.002",
                paramLabel = "E",
                description =
                        "takes samples where they are needed until the root mean square error, in linear light, is E;"
                                + " alone it means ${FALLBACK-VALUE}, half a step of an 8-bit picture")
        private Double error;

        @Option(
                names = "--seconds",
                paramLabel = "S",
                description = "takes samples where they help most, for S seconds")
        private Double seconds;
    }

    @ArgGroup
    private Wish wish = new Wish();

    @Option(names = "--seed", paramLabel = "N", description = "seed for the positions of the samples")
    private Long seed;

    /** The studio with the samples, the error and the seed that were given. */
    Studio applyTo(Studio studio) {
        RenderSettings settings =
                seed == null ? studio.settings() : studio.settings().withSeed(seed);
        if (wish.samples != null) {
            return studio.withSettings(MistakeException.inOption(
                    "--samples",
                    () -> settings.withSamples(
                            Require.within("samples", wish.samples, 1, RenderSettings.MOST_SAMPLES))));
        }
        if (wish.error != null) {
            // 0 means something to a scene, but is no error to ask for
            return studio.withSettings(MistakeException.inOption(
                    "--error", () -> settings.withTargetError(new Quality.TargetError(wish.error).rootMeanSquare())));
        }
        return studio.withSettings(settings);
    }

    /** What the studio says, unless the time is limited. */
    Quality of(Studio studio) {
        return wish.seconds == null
                ? Quality.of(studio)
                : MistakeException.inOption("--seconds", () -> new Quality.TimeLimit(wish.seconds));
    }
}
