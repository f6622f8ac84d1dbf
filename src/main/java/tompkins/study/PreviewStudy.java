package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import tompkins.image.LinearImage;
import tompkins.render.Quality;
import tompkins.render.RenderListener;
import tompkins.render.Renderer;
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
        return "one sample per pixel, " + REPEATS + " runs, scenes " + StudySetup.settings(studios);
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
            Passes passes = passes(plan);
            LinearImage coarse = passes.images.get(pass);
            double seconds = passes.seconds.get(pass);
            if (method.equals(BLOCKS)) {
                seconds = passes.secondsBefore.get(pass);
                long start = System.nanoTime();
                coarse = blocks(coarse, STRIDES[pass]);
                seconds += (System.nanoTime() - start) / 1e9;
            }
            if (run >= 0) {
                double[] picture = Photographs.light(passes.images.get(STRIDES.length));
                runs.add(Figures.of(rays, seconds, ErrorNorm.of(Photographs.light(coarse), picture), 0));
            }
        }
        return Figures.of(runs);
    }

    /** The pictures after each pass, and the times before and after they were made from the samples. */
    private record Passes(List<LinearImage> images, List<Double> secondsBefore, List<Double> seconds) {}

    private static Passes passes(RenderPlan plan) {
        Passes passes = new Passes(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        long start = System.nanoTime();
        RenderListener listener = RenderListener.afterEachPass(job -> {
            passes.secondsBefore.add((System.nanoTime() - start) / 1e9);
            passes.images.add(job.image());
            passes.seconds.add((System.nanoTime() - start) / 1e9);
        });
        try (Renderer renderer = new Renderer(1)) {
            renderer.startCoarse(plan, new Quality.Samples(1), listener).await();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new CancellationException();
        }
        return passes;
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
                .map(name -> Chart.errorAgainstTime(name, name + ", previews at every 8th, 4th and 2nd pixel")
                        .withOwn(PROGRAM))
                .toList();
    }

    @Override
    public String answer(List<Measurement> all) {
        double slowest = 0;
        double left = 0;
        StringBuilder each = new StringBuilder();
        for (String name : studios.keySet()) {
            Measurement blocks = Measurement.of(name, BLOCKS, FIRST, all);
            Measurement first = Measurement.of(name, PROGRAM, FIRST, all);
            Measurement last = Measurement.of(name, PROGRAM, LAST, all);
            slowest = Math.max(slowest, first.medianSeconds());
            left = Math.max(left, first.medianError() / blocks.medianError());
            each.append(StudyText.of(
                    "preview.first",
                    name,
                    1e3 * first.medianSeconds(),
                    1e3 * blocks.medianSeconds(),
                    1e3 * last.medianSeconds()));
        }
        return StudyText.of("preview.answer", 1e3 * slowest, 100 * left) + each;
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        List<Finding> findings = new ArrayList<>();
        for (String name : studios.keySet()) {
            double blocks = Measurement.of(name, BLOCKS, FIRST, all).medianError();
            double first = Measurement.of(name, PROGRAM, FIRST, all).medianError();
            double last = Measurement.of(name, PROGRAM, LAST, all).medianError();
            findings.add(Finding.of(
                    first < blocks,
                    name + ": error of the first preview, interpolated",
                    Finding.text("below %.2g, that of blocks", blocks),
                    "%.2g",
                    first));
            findings.add(Finding.of(
                    last < first,
                    name + ": error of the preview at every second pixel",
                    Finding.text("below %.2g, that of the first", first),
                    "%.2g",
                    last));
        }
        return findings;
    }
}
