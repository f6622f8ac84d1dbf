package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tompkins.image.LinearImage;
import tompkins.render.Quality;
import tompkins.render.RenderListener;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/**
 * How soon the window shows how much, and whether pixels that are still missing should be interpolated.
 *
 * @param studios photographs; they are taken with one sample per pixel, whatever they say
 */
record PreviewStudy(Map<String, Studio> studios) implements Study {

    private static final String BLOCKS = "coarse to fine, in blocks";
    private static final String PROGRAM = "coarse to fine, interpolated (the program)";
    private static final int[] STRIDES = {8, 4, 2};
    private static final int FIRST = STRIDES[0];
    private static final int LAST = STRIDES[STRIDES.length - 1];
    private static final int REPEATS = 5;

    /** One sample per pixel says how good a preview is. */
    PreviewStudy {
        Map<String, Studio> single = new LinkedHashMap<>();
        studios.forEach((name, studio) ->
                single.put(name, studio.withSettings(studio.settings().withSamples(1))));
        studios = single;
    }

    @Override
    public String settings() {
        return StudyText.of("preview.settings", REPEATS, StudySetup.settings(studios));
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        studios.forEach((name, studio) -> {
            RenderPlan plan = RenderPlan.of(studio);
            for (String method : List.of(BLOCKS, PROGRAM)) {
                for (int pass = 0; pass < STRIDES.length; pass++) {
                    int which = pass;
                    trials.add(new Trial(name, method, STRIDES[pass], () -> measure(method, plan, which)));
                }
            }
        });
        return trials;
    }

    private static Figures measure(String method, RenderPlan plan, int pass) {
        double rays = (double) plan.width() * plan.height() / (STRIDES[pass] * STRIDES[pass]);
        List<Figures> runs = new ArrayList<>();
        // the first runs only let the compiler warm up
        for (int run = -REPEATS; run < REPEATS; run++) {
            List<Pass> passes = passes(plan);
            LinearImage coarse = passes.get(pass).image;
            double seconds = passes.get(pass).seconds;
            if (method.equals(BLOCKS)) {
                long start = System.nanoTime();
                coarse = blocks(coarse, STRIDES[pass]);
                seconds = passes.get(pass).secondsBefore + secondsSince(start);
            }
            if (run >= 0) {
                double[] picture = Photographs.light(passes.get(STRIDES.length).image);
                runs.add(Figures.of(rays, seconds, ErrorNorm.of(Photographs.light(coarse), picture), 0));
            }
        }
        return Figures.of(runs);
    }

    /** The picture after a pass, and the seconds before and after it was made from the samples. */
    private record Pass(LinearImage image, double secondsBefore, double seconds) {}

    private static List<Pass> passes(RenderPlan plan) {
        List<Pass> passes = new ArrayList<>();
        long start = System.nanoTime();
        RenderListener listener = RenderListener.afterEachPass(job -> {
            double before = secondsSince(start);
            passes.add(new Pass(job.image(), before, secondsSince(start)));
        });
        Photographs.done(renderer -> renderer.startCoarse(plan, new Quality.Samples(1), listener));
        return passes;
    }

    private static double secondsSince(long start) {
        return (System.nanoTime() - start) / 1e9;
    }

    /** The picture that repeats every stride-th pixel of each direction. */
    private static LinearImage blocks(LinearImage image, int stride) {
        int width = image.width();
        float[] rgb = new float[image.rgb().length];
        for (int row = 0; row < image.height(); row++) {
            for (int column = 0; column < width; column++) {
                int coarse = (row - row % stride) * width + column - column % stride;
                System.arraycopy(image.rgb(), 3 * coarse, rgb, 3 * (row * width + column), 3);
            }
        }
        return new LinearImage(width, image.height(), rgb);
    }

    @Override
    public List<Chart> charts() {
        return studios.keySet().stream()
                .map(name -> Chart.errorAgainstTime(name, name + ", previews at every 8th, 4th and 2nd pixel", PROGRAM))
                .toList();
    }

    @Override
    public void conclude(List<Measurement> all, Conclusion conclusion) {
        double slowest = 0;
        double left = 0;
        for (String name : studios.keySet()) {
            Measurement first = Measurement.of(name, PROGRAM, FIRST, all);
            double blocks = Measurement.of(name, BLOCKS, FIRST, all).medianError();
            slowest = Math.max(slowest, first.medianSeconds());
            left = Math.max(left, first.medianError() / blocks);
        }
        conclusion.say("preview.answer", 1e3 * slowest, 100 * left);
        for (String name : studios.keySet()) {
            Measurement blocks = Measurement.of(name, BLOCKS, FIRST, all);
            Measurement first = Measurement.of(name, PROGRAM, FIRST, all);
            Measurement last = Measurement.of(name, PROGRAM, LAST, all);
            conclusion.say(
                    "preview.first",
                    name,
                    1e3 * first.medianSeconds(),
                    1e3 * blocks.medianSeconds(),
                    1e3 * last.medianSeconds());
            require(first, blocks, "preview.interpolated", conclusion);
            require(last, first, "preview.last", conclusion);
        }
    }

    private static void require(Measurement better, Measurement worse, String key, Conclusion conclusion) {
        double error = better.medianError();
        conclusion.demand(error < worse.medianError(), key, better.problem(), worse.medianError(), error);
    }
}
