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

    /**
     * Measures in turns, adds what has a target, and gives what tells how fast the machine is, as Markdown.
     *
     * @param isAmd whether the processor is one of AMD, on which POV-Ray is slower than on others
     */
    static String measure(int rounds, boolean isAmd, List<Measure> measures) throws InterruptedException {
        String rest = figure(rounds, false, isAmd ? 8 : 5, measures);
        String moving = figure(rounds, true, isAmd ? 13 : 7, measures);
        return Yardstick.HEAD + rest + moving;
    }

    private static String figure(int rounds, boolean isMoving, double leastFactor, List<Measure> measures)
            throws InterruptedException {
        Studio studio = isMoving ? PaperStudios.fig1b() : PaperStudios.fig1a();
        Yardstick elsewhere = isMoving ? Yardstick.MOVING : Yardstick.REST;
        double[] povRaySmall = new double[rounds];
        double[] povRay = new double[rounds];
        double[] povRayAlone = new double[rounds];
        try (Picture small = new Picture(studio, 2);
                Picture smallAlone = new Picture(studio, 1);
                Picture large = new Picture(large(studio), 2);
                Picture largeAlone = new Picture(large(studio), 1)) {
            for (int round = 0; round < rounds; round++) {
                small.take(PICTURES_IN_TURN);
                povRaySmall[round] = PovRay.milliseconds(isMoving, 640, 480, 2);
                smallAlone.take(PICTURES_IN_TURN);
                large.take(1);
                povRay[round] = PovRay.milliseconds(isMoving, LARGE_WIDTH, LARGE_HEIGHT, 2);
                largeAlone.take(1);
                povRayAlone[round] = PovRay.milliseconds(isMoving, LARGE_WIDTH, LARGE_HEIGHT, 1);
            }
            String name = elsewhere.figure();
            measures.add(againstPovRay(large.median(), name + ", two threads", povRay, leastFactor));
            measures.add(againstPovRay(largeAlone.median(), name + ", one thread", povRayAlone, leastFactor));
            measures.add(elsewhere.againstPackets(small.median(), povRaySmall));
            measures.add(Measure.ratioAtLeast(
                    name + ", 640 x 480, two threads against one", 1.85, "x", smallAlone.median() / small.median()));
            measures.add(Measure.ratioAtMost(
                    name + ", 640 x 480: allocation per sample", 100, "bytes", small.bytesPerSample()));
            measures.add(Measure.time(name + ", 640 x 480, one sample, two threads", "ms", small.median()));
            measures.add(Measure.time(name + ", 640 x 480, one sample, one thread", "ms", smallAlone.median()));
            return elsewhere.line(small.median(), povRaySmall);
        }
    }

    private static Measure againstPovRay(double time, String name, double[] povRay, double least) {
        double pov = Measure.median(povRay);
        String what = name + ", " + LARGE_WIDTH + " x " + LARGE_HEIGHT + ": times as fast as POV-Ray 3.7";
        return Double.isNaN(pov)
                ? Measure.missing(Measure.Kind.RATIO, what, PovRay.MISSING)
                : Measure.ratioAtLeast(what, least, "x", pov / time);
    }

    private static Studio large(Studio studio) {
        return studio.withSettings(studio.settings().withSize(LARGE_WIDTH, LARGE_HEIGHT));
    }
}
