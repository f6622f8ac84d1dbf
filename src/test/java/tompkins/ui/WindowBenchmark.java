package tompkins.ui;

import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import tompkins.io.StudioReader;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;

/**
 * Prints how fast the window is: from the start to the first picture, and from a change of the speed to the first and to the
 * complete picture on the screen. Needs a display: {@code xvfb-run -a mvn -q test-compile exec:java
 * -Dexec.classpathScope=test -Dexec.mainClass=tompkins.ui.WindowBenchmark -Dexec.args="scenes/fig1b.json"}.
 */
public final class WindowBenchmark {

    private static final int WARM_UP = 30;
    private static final int CHANGES = 60;

    private WindowBenchmark() {}

    /** Measures the scene files that are named, or {@code scenes/fig1b.json}. */
    public static void main(String[] arguments) throws Exception {
        long start = System.nanoTime();
        System.setProperty(
                "tompkins.settings",
                Files.createTempDirectory("tompkins-benchmark").toString());
        List<String> scenes = arguments.length == 0 ? List.of("scenes/fig1b.json") : List.of(arguments);
        for (String scene : scenes) {
            measure(scene, start, System.out);
            start = System.nanoTime();
        }
        System.exit(0);
    }

    private static void measure(String scene, long start, PrintStream out) throws Exception {
        Studio studio = StudioReader.read(Path.of(scene));
        try (WindowDriver driver = new WindowDriver(studio, null, List.of())) {
            print(out, scene, "start to first picture", List.of(System.nanoTime() - start));
            List<Long> first = new ArrayList<>();
            List<Long> complete = new ArrayList<>();
            for (int i = 0; i < WARM_UP + CHANGES; i++) {
                Studio next = studio.withVelocity(Velocity.of(
                        SpeedScale.RAPIDITY, 0.02 * (i + 1), studio.velocity().direction()));
                long change = System.nanoTime();
                WindowDriver.onEventThread(() -> {
                    driver.window().model().set(next);
                    return null;
                });
                long shown = await(driver, next, false) - change;
                long whole = await(driver, next, true) - change;
                if (i >= WARM_UP) {
                    first.add(shown);
                    complete.add(whole);
                }
            }
            print(out, scene, "change to picture on screen", first);
            print(out, scene, "change to complete picture", complete);
        }
    }

    /** Waits for a picture of a studio on the screen, painted; gives the time. */
    private static long await(WindowDriver driver, Studio studio, boolean complete) throws InterruptedException {
        while (true) {
            Picture picture = driver.picture();
            if (picture.studio() == studio && (picture.complete() || !complete)) {
                WindowDriver.onEventThread(() -> null);
                return System.nanoTime();
            }
            Thread.sleep(1);
        }
    }

    private static void print(PrintStream out, String scene, String what, List<Long> nanoseconds) {
        List<Long> sorted = new ArrayList<>(nanoseconds);
        Collections.sort(sorted);
        out.printf(
                Locale.ROOT,
                "%-24s %-30s median %7.1f ms, 90 %% below %7.1f ms%n",
                scene,
                what,
                sorted.get(sorted.size() / 2) * 1e-6,
                sorted.get(sorted.size() * 9 / 10) * 1e-6);
    }
}
