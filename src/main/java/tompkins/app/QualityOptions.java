package tompkins.app;

import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import tompkins.render.Quality;
import tompkins.studio.Studio;

/** How good a picture has to be, as one wish, and where its samples lie. */
final class QualityOptions {

    /** The wishes for a single picture, of which one at most may be given. */
    private static final class PictureWish extends QualityWish {

        @Option(
                names = "--seconds",
                paramLabel = "S",
                description = "takes samples where they help most, for S seconds")
        private Double seconds;
    }

    @ArgGroup
    private PictureWish wish = new PictureWish();

    @Option(names = "--seed", paramLabel = "N", description = "seed for the positions of the samples")
    private Long seed;

    /** The studio with the samples, the error and the seed that were given. */
    Studio applyTo(Studio studio) {
        Studio wished = wish.applyTo(studio);
        return seed == null ? wished : wished.withSettings(wished.settings().withSeed(seed));
    }

    /** What the studio says, unless the time is limited. */
    Quality of(Studio studio) {
        return wish.seconds == null
                ? Quality.of(studio)
                : MistakeException.inOption("--seconds", () -> new Quality.TimeLimit(wish.seconds));
    }
}
