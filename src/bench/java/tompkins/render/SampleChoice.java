package tompkins.render;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import tompkins.camera.PixelSampler;
import tompkins.trace.RenderPlan;

/** Pictures whose samples are chosen in ways that the program does not offer, to compare with its own. */
public final class SampleChoice {

    /** The variance of a pixel with n samples falls as {@code n^-POWER}, as the program takes it. */
    public static final double POWER = PixelVariance.POWER;

    private SampleChoice() {}

    /**
     * A picture of a wanted error, as {@link Quality.TargetError} takes it, but with another number of first samples.
     *
     * @param first of each pixel that is looked at, a power of two
     */
    public static RenderJob adaptive(Renderer renderer, RenderPlan plan, int first, double error)
            throws InterruptedException {
        Film film = new Film(plan.width(), plan.height(), plan.exposure(), true);
        boolean severalFirst = PixelVariance.needsSeveralSamples(plan);
        TimeBudget endless = new TimeBudget(Double.POSITIVE_INFINITY);
        return take(renderer, plan, new AdaptiveSchedule(film, first, severalFirst, false, error, endless), film);
    }

    /** A picture with a given number of samples of each pixel. */
    public static RenderJob given(Renderer renderer, RenderPlan plan, int[] samples) throws InterruptedException {
        Map<Integer, BitSet> chosen = new TreeMap<>();
        for (int pixel = 0; pixel < samples.length; pixel++) {
            chosen.computeIfAbsent(samples[pixel], number -> new BitSet(samples.length))
                    .set(pixel);
        }
        List<Pass> passes = new ArrayList<>();
        chosen.forEach((number, pixels) -> passes.add(new Pass(
                1,
                0,
                PixelSampler.firstOf(number),
                number,
                number,
                pixels.toLongArray(),
                (double) pixels.cardinality() / samples.length)));
        Film film = new Film(plan.width(), plan.height(), plan.exposure(), false);
        return take(renderer, plan, new FixedSchedule(passes), film);
    }

    private static RenderJob take(Renderer renderer, RenderPlan plan, Schedule schedule, Film film)
            throws InterruptedException {
        RenderJob job = renderer.start(
                plan, schedule, film, Tile.of(plan.width(), plan.height()), RenderListener.NONE, ended -> {});
        job.await();
        return job;
    }
}
