package tompkins.render;

import tompkins.property.NumberText;
import tompkins.property.Require;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** How good a picture has to be, or how long it may take. */
public sealed interface Quality {

    /** What the settings of a studio ask for. */
    static Quality of(Studio studio) {
        RenderSettings settings = studio.settings();
        return settings.targetError() > 0 ? new TargetError(settings.targetError()) : new Samples(settings.samples());
    }

    /** Says which samples the picture of a plan gets. */
    String sentence(RenderPlan plan);

    private static String spread(RenderPlan plan) {
        boolean overLens = plan.studio().camera().hasWideAperture();
        if (plan.blursInTime()) {
            return "spread evenly over pixel" + (overLens ? ", lens" : "") + " and exposure time";
        }
        return overLens ? "spread evenly over pixel and lens" : "spread evenly over the pixel";
    }

    /**
     * The same number of samples per pixel.
     *
     * @param samples 1 is taken in the centre of the pixel and of the lens, in the middle of the exposure time
     */
    record Samples(int samples) implements Quality {

        /** Checks the number. */
        public Samples {
            Require.within("samples", samples, 1, RenderSettings.MOST_SAMPLES);
        }

        @Override
        public String sentence(RenderPlan plan) {
            if (samples > 1) {
                return samples + " samples per pixel, " + spread(plan) + ".";
            }
            return "One sample per pixel, in its centre"
                    + (plan.studio().camera().hasWideAperture() ? " and through the centre of the lens" : "")
                    + (plan.blursInTime() ? ", in the middle of the exposure time" : "")
                    + (plan.blurs() ? ": blur needs more samples." : ".");
        }
    }

    /**
     * Samples where they are needed, until the picture is as good as this.
     *
     * @param rootMeanSquare root mean square error over all pixels and channels, in linear light; white is 1
     */
    record TargetError(double rootMeanSquare) implements Quality {

        /**
         * Half a step of an 8-bit picture: smaller errors are invisible. For the same error, samples where they are
         * needed take fewer rays than the same number everywhere (see the charts of antialiasing in
         * docs/speed-and-accuracy.md).
         */
        public static final TargetError DEFAULT = new TargetError(0.002);

        /** Checks the number. */
        public TargetError {
            Require.within("error", rootMeanSquare, RenderSettings.SMALLEST_ERROR, 1);
        }

        @Override
        public String sentence(RenderPlan plan) {
            return "Samples where they are needed, " + spread(plan) + ", until the estimated error is "
                    + NumberText.of(rootMeanSquare) + ".";
        }
    }

    /**
     * Samples where they help most, until the time is over.
     *
     * @param seconds from the start of the render; what has been begun by then is completed
     */
    record TimeLimit(double seconds) implements Quality {

        /** Checks the number. */
        public TimeLimit {
            Require.within("seconds", seconds, 0.01, 1e6);
        }

        @Override
        public String sentence(RenderPlan plan) {
            return "Samples where they help most, " + spread(plan) + ", until " + NumberText.of(seconds)
                    + " s are over.";
        }
    }
}
