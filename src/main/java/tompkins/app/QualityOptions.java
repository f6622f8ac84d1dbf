package tompkins.app;

import java.util.List;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Option;
import tompkins.io.Assignment;
import tompkins.property.MistakeException;
import tompkins.property.NumberText;
import tompkins.render.Quality;
import tompkins.studio.Studio;

/** How good a picture has to be, as one wish. */
final class QualityOptions {

    private static final String ERROR = "settings.targetError";

    /** The wishes that a scene can hold, too; at most one may be given. */
    static class Wish {

        @Option(names = "--samples", paramLabel = "N", description = "takes N samples per pixel, 1 or more")
        private String samples;

        @Option(
                names = "--error",
                arity = "0..1",
                fallbackValue = "0.002",
                paramLabel = "E",
                description =
                        "takes samples where they are needed, until the root mean square error in linear light is E;"
                                + " alone it means ${FALLBACK-VALUE}")
        private Double error;

        /** The values of a scene that were given. */
        List<Assignment> assignments() {
            if (samples != null) {
                return List.of(
                        new Assignment("--samples", "settings.samples", samples),
                        new Assignment("--samples", ERROR, "0"));
            }
            if (error == null) {
                return List.of();
            }
            // 0 has a meaning in a scene, but cannot be asked for as an error
            MistakeException.inOption("--error", () -> new Quality.TargetError(error));
            return List.of(new Assignment("--error", ERROR, NumberText.of(error)));
        }
    }

    /** The wishes for a single picture. */
    private static final class PictureWish extends Wish {

        @Option(
                names = "--seconds",
                paramLabel = "S",
                description =
                        "takes samples where they help most, for S seconds; taken again, it has as many on average")
        private Double seconds;
    }

    @ArgGroup
    private PictureWish wish = new PictureWish();

    /** The values of a scene that were given. */
    List<Assignment> assignments() {
        return wish.assignments();
    }

    /** What the studio says, unless the time is limited. */
    Quality of(Studio studio) {
        return wish.seconds == null
                ? Quality.of(studio)
                : MistakeException.inOption("--seconds", () -> new Quality.TimeLimit(wish.seconds));
    }
}
