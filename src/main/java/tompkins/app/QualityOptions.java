package tompkins.app;

import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import tompkins.render.Quality;
import tompkins.studio.Studio;

/** How good a picture has to be, as one wish. */
final class QualityOptions {

    /** The wishes for a single picture, at most one of which may be given. */
    private static final class PictureWish extends QualityWish {

        @Option(
                names = "--seconds",
                paramLabel = "S",
                description = "takes samples where they help most, for S seconds")
        private Double seconds;
    }

    @ArgGroup
    private PictureWish wish = new PictureWish();

    /** The studio with the samples or the error that were given. */
    Studio applyTo(Studio studio) {
        return wish.applyTo(studio);
    }

    /** What the studio says, unless the time is limited. */
    Quality of(Studio studio) {
        return wish.seconds == null
                ? Quality.of(studio)
                : MistakeException.inOption("--seconds", () -> new Quality.TimeLimit(wish.seconds));
    }
}
