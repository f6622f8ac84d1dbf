package tompkins.app;

import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import tompkins.render.Quality;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;

/** How good a picture has to be, as one wish, and where its samples lie. */
final class QualityOptions {

    /** The wishes, of which one at most may be given. */
    private static final class Wish {

        @Option(names = "--samples", paramLabel = "N", description = "takes N samples for each pixel, 1 or more")
        private Integer samples;

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

    @Option(names = "--seed", paramLabel = "N", description = "seed of the places of the samples")
    private Long seed;

    /** The studio with the number of samples and the seed that were given. */
    Studio applyTo(Studio studio) {
        RenderSettings settings = studio.settings();
        RenderSettings seeded = seed == null ? settings : settings.withSeed(seed);
        return studio.withSettings(
                wish.samples == null
                        ? seeded
                        : MistakeException.inOption("--samples", () -> seeded.withSamples(wish.samples)));
    }

    /** The wish, or what the studio says if there is none. */
    Quality of(Studio studio) {
        if (wish.error != null) {
            return MistakeException.inOption("--error", () -> new Quality.TargetError(wish.error));
        }
        return wish.seconds != null
                ? MistakeException.inOption("--seconds", () -> new Quality.TimeLimit(wish.seconds))
                : Quality.of(studio);
    }
}
