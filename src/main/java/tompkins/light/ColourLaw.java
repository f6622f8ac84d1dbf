package tompkins.light;

import tompkins.ray.Colour;

/**
 * What the motion of the camera does to the light of the scene, under the Lorentz transformation. The Doppler factor D
 * is the frequency in the camera frame divided by that in the scene frame.
 */
public enum ColourLaw {

    /** Nothing: brightness and colours stay as they are in the scene. */
    UNCHANGED {
        @Override
        public double starFactor(double temperature, double dopplerFactor) {
            return 1;
        }

        @Override
        public double brightness(double dopplerFactor) {
            return 1;
        }
    },

    /**
     * The searchlight effect alone: all light becomes brighter by D^4, as the radiance of all wavelengths together does
     * (Weiskopf, Kraus, Ruder 1999), and keeps its colour.
     */
    SEARCHLIGHT {
        @Override
        public double brightness(double dopplerFactor) {
            double square = dopplerFactor * dopplerFactor;
            return square * square;
        }
    },

    /**
     * Wavelengths are divided by D, and what is visible then becomes brighter or darker with them, as if the scene were
     * lit by a black body of 6504 K (docs/conventions.md describes the model).
     */
    DOPPLER {
        @Override
        public Colour seen(Colour light, double dopplerFactor) {
            return BlackBodyColours.seen(light, dopplerFactor);
        }

        @Override
        public Colour seen(Colour light, double lampFactor, double dopplerFactor) {
            return lampFactor == 1
                    ? seen(light, dopplerFactor)
                    : BlackBodyColours.seen(light, lampFactor * dopplerFactor, dopplerFactor);
        }

        @Override
        public Colour ofBlackBody(double temperature, double dopplerFactor) {
            return BlackBodyColours.ofTemperature(temperature, dopplerFactor);
        }

        @Override
        public double starFactor(double temperature, double dopplerFactor) {
            return BlackBodyColours.brightness(temperature, dopplerFactor) / (dopplerFactor * dopplerFactor);
        }

        @Override
        public double brightness(double dopplerFactor) {
            return BlackBodyColours.brightness(dopplerFactor);
        }
    };

    /**
     * How light looks in the camera frame.
     *
     * @param light its colour in the scene frame
     * @param dopplerFactor D, from 0 upwards
     */
    public Colour seen(Colour light, double dopplerFactor) {
        return light.times(brightness(dopplerFactor));
    }

    /**
     * How light that a lamp has sent to a surface looks in the camera frame.
     *
     * @param light its colour, as if lamp and surface had one frame
     * @param lampFactor frequency in the frame of the surface divided by that in the frame of the lamp
     * @param dopplerFactor frequency in the camera frame divided by that in the frame of the surface
     */
    public Colour seen(Colour light, double lampFactor, double dopplerFactor) {
        return seen(light.times(brightness(lampFactor)), dopplerFactor);
    }

    /**
     * How a black body looks in the camera frame, such as a star: in units in which its luminance is 1 where it rests.
     *
     * @param temperature in kelvins, in its rest frame
     * @param dopplerFactor D, from 0 upwards
     */
    public Colour ofBlackBody(double temperature, double dopplerFactor) {
        return BlackBodyColours.ofTemperature(temperature, 1).times(brightness(dopplerFactor));
    }

    /**
     * By what factor a star gets brighter: its luminance summed over all directions, which are fewer by D^-2. A star
     * has no size that could be seen, so that it stays as it is where nothing changes.
     *
     * @param temperature in kelvins, in its rest frame
     * @param dopplerFactor D, above 0
     */
    public double starFactor(double temperature, double dopplerFactor) {
        return brightness(dopplerFactor) / (dopplerFactor * dopplerFactor);
    }

    /**
     * The luminance in the camera frame of light that is white in the scene, 1 if nothing changes.
     *
     * @param dopplerFactor D, from 0 upwards
     */
    public abstract double brightness(double dopplerFactor);
}
