package tompkins.render;

import tompkins.image.LinearImage;
import tompkins.image.ToneCurve;

/**
 * How much of a picture a screen cannot show.
 *
 * @param black pixels of which all three channels are too faint for the first of 255 steps
 * @param white pixels of which all three channels are brighter than white
 */
public record Clipping(long black, long white) {

    /** Counts the pixels of a picture. */
    static Clipping of(LinearImage image, ToneCurve curve) {
        float[] rgb = image.rgb();
        long black = 0;
        long white = 0;
        for (int i = 0; i < rgb.length; i += 3) {
            float brightest = Math.max(rgb[i], Math.max(rgb[i + 1], rgb[i + 2]));
            float darkest = Math.min(rgb[i], Math.min(rgb[i + 1], rgb[i + 2]));
            black += curve.quantise(brightest, 255) == 0 ? 1 : 0;
            white += darkest > 1 ? 1 : 0;
        }
        return new Clipping(black, white);
    }
}
