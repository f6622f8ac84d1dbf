package tompkins.ui;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3d;
import tompkins.bench.Measure;
import tompkins.io.StudioReader;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.ui.picture.Picture;

/**
 * Prints how fast the window is with a scene: milliseconds from a change of the speed to the first and to the complete
 * picture on the screen, and the pictures in a second while the speed is dragged. Needs a display: {@code xvfb-run -a
 * mvn -q -Pbench test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=tompkins.ui.WindowBenchmark
 * -Dexec.args="scenes/fig1b.json"}.
 */
public final class WindowBenchmark {

    private static final int WARM_UP = 20;
    private static final int CHANGES = 40;
    private static final long DRAG_NANOSECONDS = 10_000_000_000L;

    /** A mouse tells where it is about so often. */
    private static final int MILLISECONDS_BETWEEN_MOVES = 8;

    private final Studio studio;
    private final WindowDriver driver;

    private WindowBenchmark(Studio studio, WindowDriver driver) {
        this.studio = studio;
        this.driver = driver;
    }

    /** Measures a scene file. */
    public static void main(String[] arguments) throws Exception {
        Path settings = Files.createTempDirectory("tompkins-benchmark");
        Studio studio = StudioReader.read(Path.of(arguments[0]));
        try (WindowDriver driver = new WindowDriver(settings, new FirstScene(studio, null), List.of())) {
            WindowBenchmark benchmark = new WindowBenchmark(studio, driver);
            benchmark.changes();
            benchmark.drag();
        }
        System.exit(0);
    }

    private void changes() throws InterruptedException {
        List<Long> first = new ArrayList<>();
        List<Long> complete = new ArrayList<>();
        for (int i = 0; i < WARM_UP + CHANGES; i++) {
            Studio next = studio.withVelocity(Velocity.of(
                    SpeedScale.RAPIDITY, 0.02 * (i + 1), studio.velocity().direction()));
            long change = System.nanoTime();
            show(next);
            long shown = await(next, false) - change;
            long whole = await(next, true) - change;
            if (i >= WARM_UP) {
                first.add(shown);
                complete.add(whole);
            }
        }
        print("change to picture on screen", Measure.median(first) * 1e-6);
        print("change to complete picture", Measure.median(complete) * 1e-6);
    }

    /** Moves the speed to and fro as a hand does, without waiting for pictures. */
    private void drag() throws InterruptedException {
        long start = System.nanoTime();
        int pictures = 0;
        Studio last = null;
        while (System.nanoTime() - start < DRAG_NANOSECONDS) {
            double seconds = (System.nanoTime() - start) * 1e-9;
            show(studio.withVelocity(
                    Velocity.of(SpeedScale.BETA, 0.9 + 0.09 * Math.sin(seconds), new Vector3d(0.2, -0.1, 0.97))));
            long next = System.nanoTime() + MILLISECONDS_BETWEEN_MOVES * 1_000_000L;
            while (System.nanoTime() < next) {
                Studio shown = driver.picture().studio();
                if (shown != last) {
                    last = shown;
                    pictures++;
                }
                Thread.sleep(1);
            }
        }
        print("pictures in a second while dragging", pictures / ((System.nanoTime() - start) * 1e-9));
    }

    private void show(Studio next) {
        WindowDriver.onEventThread(() -> driver.window().model().adjust(next, this));
    }

    /** Waits for a picture of a studio on the screen, painted; gives the time. */
    private long await(Studio next, boolean complete) throws InterruptedException {
        while (true) {
            Picture picture = driver.picture();
            if (picture.studio() == next && (picture.complete() || !complete)) {
                WindowDriver.onEventThread(() -> null);
                return System.nanoTime();
            }
            Thread.sleep(1);
        }
    }

    private static void print(String what, double value) {
        System.out.printf(Locale.ROOT, "%s: %.1f%n", what, value);
    }
}
