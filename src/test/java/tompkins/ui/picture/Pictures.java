package tompkins.ui.picture;

import java.time.Duration;
import java.util.List;
import tompkins.image.LinearImage;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Whole pictures that nobody rendered, for what shows and reads them. */
public final class Pictures {

    private Pictures() {}

    /** A black picture in the size of its photograph. */
    public static Picture black(Studio studio) {
        return black(studio, studio.settings().width(), studio.settings().height());
    }

    /** A black picture of a studio that may have another size on the screen. */
    public static Picture black(Studio studio, int width, int height) {
        RenderPlan plan = RenderPlan.of(studio.withSettings(studio.settings().withSize(width, height)));
        return of(studio, plan, new LinearImage(width, height, new float[3 * width * height]), Double.NaN);
    }

    /** A picture with one sample of each pixel. */
    public static Picture of(Studio studio, RenderPlan plan, LinearImage image, double error, String... warnings) {
        return new Picture(
                studio, plan, image, null, true, Duration.ZERO, 1, error, List.of(warnings), Picture.Flaw.NONE);
    }
}
