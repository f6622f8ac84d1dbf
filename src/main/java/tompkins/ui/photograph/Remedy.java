package tompkins.ui.photograph;

import java.util.Optional;
import tompkins.image.LinearImage;
import tompkins.property.Descriptions;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Texts;

/**
 * What puts a spoilt picture right at once.
 *
 * @param problem what spoils it, in a sentence
 * @param action what helps, in a few words
 * @param studio the studio after the action
 */
record Remedy(String problem, String action, Studio studio) {

    /** The largest share of pixels that may be brighter than white in a good picture. */
    private static final double MOST_WHITE = 0.1;

    /** The remedy for a picture, if there is one. */
    static Optional<Remedy> of(Picture picture) {
        Studio studio = picture.studio();
        return switch (picture.flaw()) {
            case NONE -> Optional.empty();
            case BURNT -> {
                int stops = stopsTooMany(picture.image());
                yield Optional.of(new Remedy(
                        Texts.get("remedy.burnt"),
                        stops == 1 ? Texts.get("remedy.darkerByOne") : Texts.get("remedy.darker", stops),
                        studio.withCamera(Descriptions.with(
                                studio.camera(),
                                "exposureStops",
                                studio.camera().exposureStops() - stops))));
            }
            case EMPTY ->
                FrontWindow.of(studio)
                        .map(window -> new Remedy(
                                Texts.get("remedy.empty"),
                                Texts.get("remedy.noWindow"),
                                FrontWindow.with(studio, null)));
        };
    }

    /** By how many whole stops the exposure has to go down until hardly a pixel is brighter than white. */
    static int stopsTooMany(LinearImage image) {
        float[] rgb = image.rgb();
        int[] brighter = new int[Float.MAX_EXPONENT + 2];
        for (int i = 0; i < rgb.length; i += 3) {
            float brightest = Math.max(rgb[i], Math.max(rgb[i + 1], rgb[i + 2]));
            if (brightest > 1) {
                // as many stops as halvings until it is at most 1
                int stops = Math.getExponent(brightest);
                brighter[brightest > Math.scalb(1f, stops) ? stops + 1 : stops]++;
            }
        }
        int most = (int) (MOST_WHITE * rgb.length / 3);
        int stops = brighter.length - 1;
        for (int white = brighter[stops]; stops > 0 && white <= most; white += brighter[stops]) {
            stops--;
        }
        return stops;
    }
}
