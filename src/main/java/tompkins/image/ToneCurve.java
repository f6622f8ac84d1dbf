package tompkins.image;

/** How linear light becomes the whole numbers of a picture file. Light outside [0, 1] is clipped; NaN counts as 0. */
public enum ToneCurve {

    /** Proportional, rounded down: the level is the whole part of the largest level times the light. */
    LINEAR {
        @Override
        public int quantise(double value, int maximum) {
            return (int) (maximum * clipped(value));
        }
    },

    /** The transfer function of IEC 61966-2-1 (sRGB), rounded to the nearest level. */
    SRGB {
        @Override
        public int quantise(double value, int maximum) {
            double light = clipped(value);
            double encoded = light <= 0.0031308 ? 12.92 * light : 1.055 * Math.pow(light, 1 / 2.4) - 0.055;
            return (int) (maximum * encoded + 0.5);
        }
    };

    /**
     * The level that stands for an amount of light.
     *
     * @param value linear light, any number
     * @param maximum the largest level, 255 for 8 bits and 65535 for 16
     * @return a whole number from 0 to {@code maximum}
     */
    public abstract int quantise(double value, int maximum);

    private static double clipped(double value) {
        return Math.min(1, Math.max(0, value));
    }
}
