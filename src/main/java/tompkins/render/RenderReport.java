package tompkins.render;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tompkins.property.NumberText;
import tompkins.ray.RayCounts;

/**
 * What a render did and what went wrong in it.
 *
 * @param counts what happened to its rays
 * @param missesScene whether the picture is complete, the scene has objects, and no ray met any of them
 * @param missesMoment whether the picture is complete, and its exposure showed nothing, or nothing that a flash lit
 * @param pixels pixels of the picture
 * @param sampledPixels those that have samples; time may be over before all of them have
 * @param clipping those that a screen cannot show, where the motion changes brightness; otherwise none, and while the
 *     picture is not complete
 * @param error estimated root mean square error in linear light; NaN if there is too little to estimate it from, such
 *     as one sample through a wide aperture, or pixels without any
 * @param wantedError the error that was to be reached; 0 if there is none, or the picture is not complete
 * @param time how long it took
 */
public record RenderReport(
        RayCounts counts,
        boolean missesScene,
        boolean missesMoment,
        long pixels,
        long sampledPixels,
        Clipping clipping,
        double error,
        double wantedError,
        Duration time) {

    /** If more than this fraction of a picture is black, its exposure must be wrong. */
    private static final double MOST_BLACK = 0.9;

    /** If more than this fraction of a picture is white, its exposure must be wrong. */
    private static final double MOST_WHITE = 0.5;

    /** More than this fraction of the light can be seen to be missing. */
    private static final double MOST_LOST = 0.01;

    /** Mean number of samples of a pixel. */
    public double samplesPerPixel() {
        return (double) counts.samples / pixels;
    }

    /** Whether the motion makes so much of the picture brighter than white that the exposure must be wrong. */
    public boolean isBurnt() {
        return clipping.white() > MOST_WHITE * pixels;
    }

    /** What the user should know: one sentence for each kind of trouble. */
    public List<String> warnings() {
        List<String> warnings = new ArrayList<>();
        if (missesScene) {
            warnings.add("no ray met an object of the scene: another direction, a wider field of view or a lower speed"
                    + " may show some");
        }
        if (missesMoment) {
            warnings.add(
                    "no sample met anything in the exposure: what is there, or lit, for a short part of it takes more"
                            + " samples, or a shorter exposureTime");
        }
        if (sampledPixels < pixels) {
            warnings.add(pixels - sampledPixels + " of " + pixels
                    + " pixels got no sample and are interpolated between the others");
        }
        if (clipping.black() > MOST_BLACK * pixels) {
            warnings.add(clipping.black() + " of " + pixels + " pixels are black: light becomes too faint away from the"
                    + " middle; a higher exposure shows more of it");
        }
        if (isBurnt()) {
            warnings.add(clipping.white() + " of " + pixels
                    + " pixels are brighter than white: a lower exposure shows more of them");
        }
        if (wantedError > 0 && error > wantedError) {
            warnings.add("the estimated error did not come down to " + NumberText.of(wantedError)
                    + ": no pixel gets more than " + AdaptiveSchedule.MOST_SAMPLES + " samples");
        }
        warn(warnings, counts.withoutFocus, "missed the surface in focus and were focused at infinity");
        warn(warnings, counts.withoutShutter, "never crossed the shutter and stayed black");
        warn(warnings, counts.notFinite, "had no colour that a picture can hold and stayed black");
        if (counts.tooDeep > 0) {
            warnings.add(counts.tooDeep + " rays met more surfaces than maximumDepth allows; their light is missing");
        }
        if (counts.lostLight() > MOST_LOST * counts.samples) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "%d rays were too faint to be followed; together they could have brought %.2g %% of the light",
                    counts.tooFaint,
                    100 * counts.lostLight() / counts.samples));
        }
        return warnings;
    }

    private void warn(List<String> warnings, long count, String what) {
        if (count > 0) {
            warnings.add(count + " of " + counts.samples + " samples " + what);
        }
    }
}
