package tompkins.light;

import tompkins.ray.Colour;
import tompkins.ray.Ray;

/**
 * What becomes of the light of the scene on its way into the camera frame. If it is metered, white light keeps its
 * luminance in the middle of the picture, because a fast camera would see everything ahead thousands of times too
 * bright. What moves with the camera is left as it is. Immutable, shared by all threads.
 */
public final class LightShift {

    /** The largest factor by which the scene is made brighter; what is fainter stays dark. */
    private static final double MOST_GAIN = 0x1p20;

    /** Far brighter than a picture can show, and still a number when it is summed. */
    private static final double BRIGHTEST = 0x1p80;

    /** What rounding leaves of a ratio of 1. */
    private static final double ROUNDING = 1e-12;

    private final ColourLaw law;
    private final Metering metering;
    private final double middle;
    private final double gain;

    /**
     * The shift under a law.
     *
     * @param middle the Doppler factor of the scene in the middle of the picture
     * @param directionLength that of the ray there, in the scene frame
     */
    public LightShift(ColourLaw law, Metering metering, double middle, double directionLength) {
        this.law = law;
        this.metering = metering;
        this.middle = middle;
        double white = law.brightness(Math.max(0, middle)) * brightness(middle, directionLength);
        gain = metering == Metering.NONE ? 1 : Math.min(MOST_GAIN, 1 / white);
    }

    /**
     * The colour that light has for the camera which leaves a hit, or what is behind all objects, along a ray.
     *
     * @param light the colour in the frame of the ray, as if its lamp had the same frame
     * @param lampFactor frequency in that frame divided by that in the frame of the lamp that it comes from
     */
    public Colour seen(Colour light, Ray ray, double lampFactor) {
        return seen(light.times(ray.weight), lampFactor, 1 / ray.frequency, ray.directionLength);
    }

    /** As above, for a ray that comes straight from the camera, and light whose lamp rests in the frame of the ray. */
    public Colour seen(Colour light, double dopplerFactor, double directionLength) {
        return seen(light, 1, dopplerFactor, directionLength);
    }

    /**
     * The colour that light has for the camera. If the camera outruns the light of a medium, or what it sees does,
     * there may be no Doppler factor above 0; then colours stay as they are.
     *
     * <p>Radiance goes with the fourth power of the length of the tangent of a ray in the frames of two observers. In
     * vacuum that is the fourth power of the Doppler factor, and what the law has made of it; in a medium that moves it
     * is another number.
     *
     * @param light the colour where it was sent out, as if its lamp had the same frame
     * @param lampFactor frequency in that frame divided by that in the frame of the lamp that it comes from
     * @param dopplerFactor frequency in the camera frame divided by that in that frame
     * @param directionLength that of the ray along which it is seen
     */
    private Colour seen(Colour light, double lampFactor, double dopplerFactor, double directionLength) {
        if (!(dopplerFactor > 0)) {
            return light;
        }
        Colour seen = lampFactor == 1 ? law.seen(light, dopplerFactor) : law.seen(light, lampFactor, dopplerFactor);
        return metered(seen, dopplerFactor, directionLength);
    }

    /**
     * The colour that a black body of the scene has for the camera, in units in which its luminance is 1 where it
     * rests.
     *
     * @param temperature in kelvins, in the scene frame
     * @param dopplerFactor frequency in the camera frame divided by that in the scene frame
     * @param directionLength that of the ray along which it is seen
     */
    public Colour ofBlackBody(double temperature, double dopplerFactor, double directionLength) {
        return dopplerFactor > 0
                ? metered(law.ofBlackBody(temperature, dopplerFactor), dopplerFactor, directionLength)
                : ColourLaw.UNCHANGED.ofBlackBody(temperature, 1);
    }

    private Colour metered(Colour seen, double dopplerFactor, double directionLength) {
        double correction = gain * brightness(dopplerFactor, directionLength);
        return new Colour(
                limited(seen.red() * correction),
                limited(seen.green() * correction),
                limited(seen.blue() * correction));
    }

    /** By how much light in a medium is brighter than it were in vacuum with the same Doppler factor. */
    private static double brightness(double dopplerFactor, double directionLength) {
        double ratio = 1 / (dopplerFactor * directionLength);
        return Math.abs(ratio - 1) < ROUNDING ? 1 : ratio * ratio * ratio * ratio;
    }

    private static double limited(double channel) {
        return channel > BRIGHTEST ? BRIGHTEST : channel;
    }

    /** The law. */
    public ColourLaw law() {
        return law;
    }

    /** How the light is metered. */
    public Metering metering() {
        return metering;
    }

    /** The Doppler factor in the middle of the picture. */
    public double middle() {
        return middle;
    }

    /** Whether the middle of the picture stays dark, because it is too faint. */
    public boolean isTooFaint() {
        return gain == MOST_GAIN;
    }

    /** By how many stops the metering makes the scene brighter. */
    public double stops() {
        return Math.log(gain) / Math.log(2);
    }
}
