package tompkins.ui;

import java.awt.Dimension;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3d;
import tompkins.io.StudioReader;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.ui.panel.RidePilot;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;

/**
 * Prints how live a ride through scenes is, in a window whose picture has 640 x 480 pixels: the pictures in a second,
 * and milliseconds from thrust to the first picture on the screen that shows it. With {@code beside-rest} before a
 * scene the camera at rest is seen beside it, as when the program starts. Needs a display.
 */
public final class RideBenchmark {

    /** Before a scene: it is seen beside the camera at rest. */
    public static final String BESIDE_REST = "beside-rest";

    private static final Dimension SIZE = new Dimension(640, 480);
    private static final int WARM_UP = 4;

    /** How long there is thrust in one direction, and none after it. */
    private static final long THRUST_NANOSECONDS = 600_000_000L;

    private static final int COASTING_MILLISECONDS = 150;

    private final WindowDriver driver;
    private final RidePilot pilot;
    private final int thrusts;
    private final List<Double> answers = new ArrayList<>();
    private final List<Double> rates = new ArrayList<>();

    private RideBenchmark(WindowDriver driver, int thrusts) {
        this.driver = driver;
        this.thrusts = thrusts;
        pilot = driver.window().motion().pilot();
    }

    /** Measures scene files, one after the other; the first argument tells how often there is thrust in each. */
    public static void main(String[] arguments) throws Exception {
        Path settings = Files.createTempDirectory("tompkins-benchmark");
        boolean besideRest = false;
        int thrusts = Integer.parseInt(arguments[0]);
        for (String argument : List.of(arguments).subList(1, arguments.length)) {
            if (argument.equals(BESIDE_REST)) {
                besideRest = true;
                continue;
            }
            FirstScene first = new FirstScene(StudioReader.read(Path.of(argument)), null, "", besideRest);
            try (WindowDriver driver = new WindowDriver(settings, first, List.of())) {
                RideBenchmark benchmark = new RideBenchmark(driver, thrusts);
                benchmark.resize();
                benchmark.ride();
                benchmark.print(Path.of(argument).getFileName() + (besideRest ? ", beside rest" : ""));
            }
            besideRest = false;
        }
        System.exit(0);
    }

    private void resize() {
        WindowDriver.onEventThread(() -> {
            PictureCanvas canvas = driver.window().view().canvas();
            canvas.setPreferredSize(SIZE);
            driver.window().side().setShown(false);
            driver.window().frame().setMinimumSize(null);
            driver.window().frame().pack();
        });
        WindowDriver.await(
                "the size of the picture",
                () -> driver.window().view().canvas().pictureBounds().getSize().equals(SIZE));
        driver.completePicture();
    }

    /** The camera rides to and fro from where the scene has it, at first at rest. */
    private void ride() throws InterruptedException {
        WindowDriver.onEventThread(() -> {
            Studio studio = driver.window().model().studio();
            driver.window().model().adjust(studio.withVelocity(Velocity.REST), this);
        });
        driver.completePicture();
        WindowDriver.onEventThread(() -> pilot.setRiding(true));
        double sense = 1;
        for (int i = 0; i < WARM_UP + thrusts; i++) {
            if (i == WARM_UP) {
                answers.clear();
                rates.clear();
            }
            thrust(sense);
            sense = -sense;
        }
        WindowDriver.onEventThread(() -> pilot.setRiding(false));
    }

    private void thrust(double sense) throws InterruptedException {
        Picture last = driver.picture();
        Velocity before = last.studio().velocity();
        int pictures = 0;
        boolean answered = false;
        long input = System.nanoTime();
        WindowDriver.onEventThread(() -> pilot.setThrust(new Vector3d(0, 0, sense)));
        while (System.nanoTime() - input < THRUST_NANOSECONDS) {
            Picture shown = driver.picture();
            if (shown.studio() != last.studio()) {
                pictures++;
                last = shown;
            }
            if (!answered && !shown.studio().velocity().equals(before)) {
                answered = true;
                answers.add((System.nanoTime() - input) * 1e-6);
            }
            Thread.sleep(1);
        }
        rates.add(pictures / (THRUST_NANOSECONDS * 1e-9));
        WindowDriver.onEventThread(pilot::stopThrust);
        // all pictures with thrust are on the screen
        Thread.sleep(COASTING_MILLISECONDS);
    }

    private static double median(List<Double> values) {
        List<Double> sorted = new ArrayList<>(values);
        Collections.sort(sorted);
        return sorted.get(sorted.size() / 2);
    }

    private void print(String scene) {
        System.out.printf(Locale.ROOT, "%s: %.1f %.1f%n", scene, median(rates), median(answers));
    }
}
