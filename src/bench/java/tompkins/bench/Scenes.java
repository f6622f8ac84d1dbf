package tompkins.bench;

import java.util.Locale;
import org.junit.jupiter.api.Named;
import tompkins.render.RenderReport;
import tompkins.studio.SceneFiles;
import tompkins.studio.Studio;

/** All scene files as they are, one after the other with one and two threads, round by round. */
final class Scenes {

    private static final int FEWEST_ROUNDS = 2;

    /** Slow scenes get fewer rounds. */
    private static final long LONGEST_SCENE_NANOSECONDS = 2_000_000_000L;

    private Scenes() {}

    /** Measures all, and gives the table as Markdown. */
    static String measure(int rounds) throws InterruptedException {
        StringBuilder table = new StringBuilder("""

                ## Scenes

                As they are, warm; millions of rays per second with 1 and 2 threads.

                | scene | ms, 2 threads | rays, 1 | rays, 2 | shadow rays, 1 | shadow rays, 2 | bytes per ray | nodes per ray | tests per ray |
                | --- | --- | --- | --- | --- | --- | --- | --- | --- |
                """);
        for (Named<Studio> scene : SceneFiles.all().toList()) {
            try (Picture alone = new Picture(scene.getPayload(), 1);
                    Picture both = new Picture(scene.getPayload(), 2)) {
                long start = System.nanoTime();
                for (int round = 0;
                        round < FEWEST_ROUNDS
                                || round < rounds && System.nanoTime() - start < LONGEST_SCENE_NANOSECONDS;
                        round++) {
                    alone.take(1);
                    both.take(1);
                }
                table.append(row(scene.getName(), alone.median(), both));
            }
        }
        return table.toString();
    }

    private static String row(String name, double alone, Picture both) {
        RenderReport report = both.report();
        double rays = report.counts().rays + report.counts().shadowRays;
        return String.format(
                Locale.ROOT,
                "| %s | %.1f | %.2f | %.2f | %.2f | %.2f | %.0f | %.2f | %.2f |%n",
                name,
                both.median(),
                report.counts().rays / alone / 1000,
                report.counts().rays / both.median() / 1000,
                report.counts().shadowRays / alone / 1000,
                report.counts().shadowRays / both.median() / 1000,
                both.bytesPerSample() * report.counts().samples / rays,
                report.counts().nodes / rays,
                report.counts().tests / rays);
    }
}
