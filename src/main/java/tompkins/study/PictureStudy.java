package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import tompkins.camera.PixelSampler;
import tompkins.camera.Sampler;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Speed against accuracy of one picture, made smaller, for each quality that can be chosen. */
public final class PictureStudy {

    static final String ADAPTIVE = "where needed";
    static final String FIXED = "the same number everywhere";
    static final String CENTRE = "one sample in the centre";
    static final String ANYWHERE = "one sample anywhere";
    static final int SEEDS = 3;

    private static final String PICTURE = "picture";
    private static final int WIDTH = 80;
    private static final int REFERENCE_SAMPLES = 2048;
    private static final int MOST_SAMPLES = 256;

    private final String name;
    private final long seed;
    private final boolean sharp;
    private final ScenePixels pixels;

    /**
     * The study of a studio's picture.
     *
     * @param cancelled asked now and then whether to stop
     */
    public PictureStudy(Studio studio, BooleanSupplier cancelled) {
        this(PICTURE, studio, studio.settings().seed(), WIDTH, REFERENCE_SAMPLES, cancelled);
    }

    /**
     * The study of a picture.
     *
     * @param name the problem of its measurements
     * @param seed of the first of several runs
     * @param width of the measured picture in pixels
     * @param referenceSamples samples per pixel of the reference
     * @param cancelled asked now and then whether to stop
     */
    PictureStudy(String name, Studio studio, long seed, int width, int referenceSamples, BooleanSupplier cancelled) {
        this.name = name;
        this.seed = seed;
        Studio small = Photographs.small(studio, width);
        sharp = !RenderPlan.of(small).blurs();
        pixels = new ScenePixels(small, ScenePixels.ALL, referenceSamples, Double.POSITIVE_INFINITY, cancelled);
    }

    /**
     * What is to be measured.
     *
     * @param others whether to measure also a sample that cannot be chosen
     */
    List<Trial> trials(boolean others) {
        List<Trial> trials = new ArrayList<>();
        // the centre of the lens in the middle of the exposure makes another picture if that blurs
        if (sharp) {
            trials.add(photographed(CENTRE, 1, new Quality.Samples(1)));
        }
        if (sharp && others) {
            Sampler anywhere = new PixelSampler(seed, false, false);
            trials.add(new Trial(name, ANYWHERE, 1, () -> pixels.sampled(anywhere, 1)));
        }
        for (int samples = 4; samples <= MOST_SAMPLES; samples *= 4) {
            trials.add(photographed(FIXED, samples, new Quality.Samples(samples)));
        }
        for (double target = 0.032; target > 0.0009; target /= 2) {
            trials.add(photographed(ADAPTIVE, target, new Quality.TargetError(target)));
        }
        return trials;
    }

    private Trial photographed(String method, double setting, Quality quality) {
        return new Trial(name, method, setting, () -> pixels.photographed(seed, SEEDS, quality));
    }

    /** The chart. */
    public Chart chart() {
        return Chart.errorAgainstTime(name, "This picture, smaller; a click on a point sets the quality", "");
    }

    /**
     * Measures all points, one after the other.
     *
     * @param listener told of all points so far
     * @throws java.util.concurrent.CancellationException soon after the study was cancelled
     */
    public void measure(Consumer<List<StudyPoint>> listener) {
        List<StudyPoint> measured = new ArrayList<>();
        for (Trial trial : trials(false)) {
            measured.add(trial.measure());
            listener.accept(List.copyOf(measured));
        }
    }

    /** The quality of a point. */
    public Quality qualityOf(StudyPoint point) {
        return point.method().equals(ADAPTIVE)
                ? new Quality.TargetError(point.setting())
                : new Quality.Samples((int) point.setting());
    }
}
