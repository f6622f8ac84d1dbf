package tompkins.bench;

import java.util.List;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;

/**
 * The paper's two figures, alternating with one thread, two threads and POV-Ray. POV-Ray is compared at four times the
 * size: at 640 x 480 a good part of its time is the start of its threads.
 */
final class Figures {

    /** Pictures of one kind that follow each other in a round. */
    private static final int PICTURES_IN_TURN = 5;

    private static final int LARGE_WIDTH = 1280;
    private static final int LARGE_HEIGHT = 960;

    private Figures() {}

    /** Measures in turns, adds what has a target, and gives what tells how fast the machine is, as Markdown. */
    static String measure(int rounds, List<Measure> measures) throws InterruptedException {
        double[] povRest = new double[rounds];
        double[] povMoving = new double[rounds];
        double[] povRestSmall = new double[rounds];
        double[] povMovingSmall = new double[rounds];
        try (Picture rest = new Picture(PaperStudios.fig1a(), 2);
                Picture restLarge = new Picture(large(PaperStudios.fig1a()), 2);
                Picture movingLarge = new Picture(large(PaperStudios.fig1b()), 2);
                Picture restAlone = new Picture(PaperStudios.fig1a(), 1);
                Picture moving = new Picture(PaperStudios.fig1b(), 2);
                Picture movingAlone = new Picture(PaperStudios.fig1b(), 1)) {
            List<Picture> pictures = List.of(rest, moving, restAlone, movingAlone);
            for (int round = 0; round < rounds; round++) {
                for (Picture picture : pictures) {
                    picture.take(PICTURES_IN_TURN);
                }
                povRestSmall[round] = PovRay.milliseconds(false, 640, 480);
                povMovingSmall[round] = PovRay.milliseconds(true, 640, 480);
                restLarge.take(1);
                povRest[round] = PovRay.milliseconds(false, LARGE_WIDTH, LARGE_HEIGHT);
                movingLarge.take(1);
                povMoving[round] = PovRay.milliseconds(true, LARGE_WIDTH, LARGE_HEIGHT);
            }
            against(rest.median(), 30, 130, Yardstick.REST, measures);
            measures.add(againstPovRay(restLarge.median(), "fig1a", povRest));
            against(moving.median(), 15, 140, Yardstick.MOVING, measures);
            measures.add(againstPovRay(movingLarge.median(), "fig1b", povMoving));
            measures.add(
                    Measure.atLeast("fig1a, two threads against one", 1.85, "x", restAlone.median() / rest.median()));
            measures.add(Measure.atMost("fig1b: allocation per sample", 1000, "bytes", moving.bytesPerSample()));
            return Yardstick.HEAD
                    + Yardstick.REST.line(rest.median(), povRestSmall)
                    + Yardstick.MOVING.line(moving.median(), povMovingSmall);
        }
    }

    private static void against(
            double time, double most, double drTimFactor, Yardstick elsewhere, List<Measure> measures) {
        String name = elsewhere.figure();
        measures.add(Measure.atMost(name + ", 640 x 480, one sample, 2 threads", most, "ms", time));
        measures.add(Measure.atLeast(
                name + " against Dr TIM, " + Measure.number(elsewhere.drTim()) + " ms",
                drTimFactor,
                "x",
                elsewhere.drTim() / time));
        measures.add(Measure.atMost(name + " against a native scalar tree tracer", elsewhere.tree(), "ms", time));
        measures.add(Measure.atMost(name + " against Embree, single rays", elsewhere.embree(), "ms", time));
        measures.add(Measure.atMost(
                name + " against native 16-wide packets, " + elsewhere.packets() + " ms",
                6,
                "x",
                time / elsewhere.packets()));
    }

    private static Measure againstPovRay(double time, String name, double[] povRay) {
        double pov = Measure.median(povRay);
        String what = name + ", " + LARGE_WIDTH + " x " + LARGE_HEIGHT + ", against POV-Ray 3.7 in this run";
        return Double.isNaN(pov)
                ? Measure.missing(what, "POV-Ray is not installed (apt-get install povray)")
                : Measure.atLeast(what + ", " + Measure.number(pov) + " ms", 5, "x", pov / time);
    }

    private static Studio large(Studio studio) {
        return studio.withSettings(studio.settings().withSize(LARGE_WIDTH, LARGE_HEIGHT));
    }
}
