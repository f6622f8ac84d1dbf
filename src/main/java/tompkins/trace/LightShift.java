package tompkins.trace;

import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.ray.Colour;

/**
 * What becomes of the light of the scene on its way into the camera frame. If it is metered, white light keeps its
 * luminance in the middle of the picture, because a fast camera would see everything ahead thousands of times too
 * bright. What moves with the camera is left as it is. Immutable, shared by all threads.
 */
final class LightShift {

    /** The largest factor by which the scene is made brighter; what is fainter stays dark. */
    private static final double MOST_GAIN = 0x1p20;

    /** Far brighter than a picture can show, and still a number when it is summed. */
    private static final double BRIGHTEST = 0x1p80;

    private final ColourLaw law;
    private final Metering metering;
    private final double middle;
    private final double gain;

    /** The shift under a law, for a picture with the given Doppler factor in its middle. */
    LightShift(ColourLaw law, Metering metering, double middle) {
        this.law = law;
        this.metering = metering;
        this.middle = middle;
        gain = metering == Metering.NONE ? 1 : Math.min(MOST_GAIN, 1 / law.brightness(middle));
    }

    /**
     * The colour in the camera frame.
     *
     * @param light the colour in the scene frame
     * @param dopplerFactor frequency in the camera frame divided by that in the scene frame
     */
    Colour seen(Colour light, double dopplerFactor) {
        Colour seen = law.seen(light, dopplerFactor);
        return new Colour(limited(seen.red()), limited(seen.green()), limited(seen.blue()));
    }

    /**
     * The colour in the camera frame of light that a lamp has sent to a surface. If the camera outruns the light of a
     * medium there may be no factor above 0; then colours stay as they are.
     *
     * @param light the colour, as if lamp and surface had one frame
     * @param lampFactor frequency in the frame of the surface divided by that in the frame of the lamp
     * @param dopplerFactor frequency in the camera frame divided by that in the frame of the surface
     */
    Colour seen(Colour light, double lampFactor, double dopplerFactor) {
        if (!(dopplerFactor > 0)) {
            return light;
        }
        Colour seen = lampFactor == 1 ? law.seen(light, dopplerFactor) : law.seen(light, lampFactor, dopplerFactor);
        return new Colour(limited(seen.red()), limited(seen.green()), limited(seen.blue()));
    }

    private double limited(double channel) {
        double metered = channel * gain;
        return metered > BRIGHTEST ? BRIGHTEST : metered;
    }

    /** The law. */
    ColourLaw law() {
        return law;
    }

    /** How the light is metered. */
    Metering metering() {
        return metering;
    }

    /** The Doppler factor in the middle of the picture. */
    double middle() {
        return middle;
    }

    /** Whether the middle of the picture stays dark, because it is too faint. */
    boolean isTooFaint() {
        return gain == MOST_GAIN;
    }

    /** By how many stops the metering makes the scene brighter. */
    double stops() {
        return Math.log(gain) / Math.log(2);
    }
}
