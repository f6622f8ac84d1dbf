package tompkins.bench;

import java.util.Random;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;

/** How many samples the wide lens of Fig. 3(a) needs: those of the sampler against random points of pixel and lens. */
final class Convergence {

    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;
    private static final int PIXELS = WIDTH * HEIGHT;
    private static final double GOAL = 0.002;

    private final double[] reference;

    /** Takes the reference, with another seed, from the given number of samples. */
    Convergence(int referenceSamples) {
        reference = sampled(referenceSamples, 99);
    }

    /** Compares the numbers of samples that the goal needs. */
    Measure measure() {
        int samples = 16;
        double before = Double.NaN;
        double error = error(sampled(samples, 1));
        while (error > GOAL && samples < 8192) {
            samples *= 2;
            before = error;
            error = error(sampled(samples, 1));
        }
        if (error > GOAL) {
            return Measure.missing("fig3a to RMSE " + GOAL, "the reference is too rough to tell");
        }
        // between two powers of two, along a straight line of the logarithms
        double share = Math.log(before / GOAL) / Math.log(before / error);
        double needed = samples / 2.0 * Math.pow(2, share);
        int tried = 256;
        double randomError = error(random(tried));
        double randomNeeded = tried * Math.pow(randomError / GOAL, 2);
        String what = "fig3a to RMSE " + GOAL + ": " + Measure.number(needed) + " samples a pixel; random "
                + Measure.number(randomNeeded);
        return Measure.atLeast(what, 20, "x fewer", randomNeeded / needed);
    }

    private static double[] sampled(int samples, long seed) {
        Studio studio = PaperStudios.fig3a();
        RenderPlan plan = RenderPlan.of(studio.withSettings(
                studio.settings().withSize(WIDTH, HEIGHT).withSamples(samples).withSeed(seed)));
        SampleTracer tracer = plan.tracer(new RayCounts());
        double[] sums = new double[3 * PIXELS];
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            for (int sample = 0; sample < samples; sample++) {
                add(sums, pixel, tracer.sample(pixel % WIDTH, pixel / WIDTH, sample), samples);
            }
        }
        return sums;
    }

    private static double[] random(int samples) {
        Studio studio = PaperStudios.fig3a();
        SampleTracer tracer = RenderPlan.of(
                        studio.withSettings(studio.settings().withSize(WIDTH, HEIGHT)))
                .tracer(new RayCounts());
        Random random = new Random(5);
        double[] sums = new double[3 * PIXELS];
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            for (int sample = 0; sample < samples; sample++) {
                double radius = Math.sqrt(random.nextDouble());
                double angle = 2 * Math.PI * random.nextDouble();
                Colour colour = tracer.sample(
                        pixel % WIDTH + random.nextDouble(),
                        pixel / WIDTH + random.nextDouble(),
                        radius * Math.cos(angle),
                        radius * Math.sin(angle));
                add(sums, pixel, colour, samples);
            }
        }
        return sums;
    }

    private static void add(double[] sums, int pixel, Colour colour, int samples) {
        sums[3 * pixel] += colour.red() / samples;
        sums[3 * pixel + 1] += colour.green() / samples;
        sums[3 * pixel + 2] += colour.blue() / samples;
    }

    private double error(double[] picture) {
        double sum = 0;
        for (int i = 0; i < picture.length; i++) {
            sum += (picture[i] - reference[i]) * (picture[i] - reference[i]);
        }
        return Math.sqrt(sum / picture.length);
    }
}
