package tompkins.render;

import tompkins.property.Require;
import tompkins.trace.RenderPlan;

/** How good a picture has to be, or how long it may take. */
public sealed interface Quality {

    /** The same number of samples for each pixel, as the scene asks for. */
    static Quality of(RenderPlan plan) {
        return new Samples(plan.samples());
    }

    /**
     * The same number of samples for each pixel.
     *
     * @param samples 1 is taken in the centre of the pixel and of the lens
     */
    record Samples(int samples) implements Quality {

        /** Checks the number. */
        public Samples {
            Require.within("samples", samples, 1, 1 << 20);
        }
    }

    /**
     * Samples where they are needed, until the picture is as good as this.
     *
     * @param rootMeanSquare root mean square error over all pixels and channels, in linear light; white is 1
     */
    record TargetError(double rootMeanSquare) implements Quality {

        /** Half a step of a picture of 8 bits: nobody sees less. */
        public static final TargetError DEFAULT = new TargetError(0.002);

        /** Checks the number. */
        public TargetError {
            Require.within("error", rootMeanSquare, 1e-6, 1);
        }
    }

    /**
     * Samples where they help most, until the time is over.
     *
     * @param seconds from the start of the render; what was begun by then is completed
     */
    record TimeLimit(double seconds) implements Quality {

        /** Checks the number. */
        public TimeLimit {
            Require.within("seconds", seconds, 0.01, 1e6);
        }
    }
}
