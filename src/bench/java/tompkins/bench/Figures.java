package tompkins.bench;

import java.util.ArrayList;
import java.util.List;
import tompkins.render.Renderer;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** The paper's two figures: how long they take with one sample in each pixel and two threads. */
final class Figures {

    private Figures() {}

    /**
     * Measures both.
     *
     * @param pictures how many of each are taken; the compiler has settled after half of them
     */
    static void measure(int pictures, List<Measure> measures) throws InterruptedException {
        addTime("fig1a", PaperStudios.fig1a(), pictures, measures);
        addTime("fig1b", PaperStudios.fig1b(), pictures, measures);
    }

    /** From the plan to the last pixel; the prepared scene is taken over, as the window does. */
    private static void addTime(String name, Studio studio, int pictures, List<Measure> measures)
            throws InterruptedException {
        List<Double> milliseconds = new ArrayList<>();
        try (Renderer renderer = new Renderer(2)) {
            RenderPlan plan = null;
            for (int i = 0; i < pictures; i++) {
                long start = System.nanoTime();
                plan = RenderPlan.of(studio, plan);
                renderer.render(plan);
                milliseconds.add((System.nanoTime() - start) / 1e6);
            }
        }
        measures.add(Measure.of(
                name + ", 640 x 480, one sample, two threads",
                "ms",
                Measure.median(milliseconds.subList(pictures / 2, pictures))));
    }
}
