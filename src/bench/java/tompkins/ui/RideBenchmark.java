package tompkins.ui;

import java.awt.Dimension;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.joml.Vector3d;
import tompkins.bench.Measure;
import tompkins.image.BufferedImages;
import tompkins.image.LinearImage;
import tompkins.image.PictureDifference;
import tompkins.image.ToneCurve;
import tompkins.io.StudioReader;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.ScreenPicture;
import tompkins.ui.ride.RidePilot;

/**
 * Prints how live a ride through scenes is, in a window whose picture has 826 x 620 pixels: the pictures in a second,
 * milliseconds from thrust to the first picture on the screen that shows it, and the root mean square difference in
 * levels of 255 to the picture with a sample in each pixel, in the median and in the worst second. If the scene has a
 * ride, all but the second number are those of its replay. With {@code beside-rest} before a scene the camera at rest
 * is seen beside it, as when the program starts. Needs a display.
 */
public final class RideBenchmark {

    /** Before a scene: it is seen beside the camera at rest. */
    public static final String BESIDE_REST = "beside-rest";

    private static final Dimension SIZE = new Dimension(826, 620);
    private static final int WARM_UP = 4;

    /** How many pictures of a second are compared with whole ones. */
    private static final int COMPARED = 3;

    /** How long there is thrust in one direction, and none after it. */
    private static final long THRUST_NANOSECONDS = 600_000_000L;

    private static final long SECOND = 1_000_000_000L;

    private static final int COASTING_MILLISECONDS = 150;

    private final WindowDriver driver;
    private final RidePilot pilot;
    private final int thrusts;
    private final List<Double> answers = new ArrayList<>();
    private final List<Double> rates = new ArrayList<>();

    /** Pictures to compare, second by second. */
    private final List<List<ScreenPicture>> seconds = new ArrayList<>();

    // used by the event thread only
    private final List<ScreenPicture> kept = new ArrayList<>();
    private Picture last;
    private int pictures;
    private long start;
    private long length = THRUST_NANOSECONDS;
    private Consumer<Picture> look = shown -> {};

    private RideBenchmark(WindowDriver driver, int thrusts) {
        this.driver = driver;
        this.thrusts = thrusts;
        pilot = driver.window().motion.pilot();
        PictureCanvas canvas = driver.window().view().canvas();
        // nothing is asked while pictures come, which would take time from them; they are on the screen once painted
        canvas.addOverlay((g, picture, bounds, visible, free) -> {
            if (picture != last) {
                last = picture;
                ScreenPicture shown = canvas.shown();
                SwingUtilities.invokeLater(() -> count(shown));
            }
        });
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
            Studio read = StudioReader.read(Path.of(argument));
            Studio sized = read.withSettings(read.settings().withSize(SIZE.width, SIZE.height));
            FirstScene first = new FirstScene(sized, null, "", besideRest);
            try (WindowDriver driver = new WindowDriver(settings, first, List.of())) {
                RideBenchmark benchmark = new RideBenchmark(driver, thrusts);
                benchmark.resize();
                benchmark.ride();
                if (!sized.ride().isEmpty()) {
                    benchmark.replay(sized);
                }
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
            driver.window().side.setShown(false);
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
                seconds.clear();
            }
            thrust(sense);
            sense = -sense;
        }
        WindowDriver.onEventThread(() -> pilot.setRiding(false));
    }

    /** The ride that the scene holds. */
    private void replay(Studio beginning) throws InterruptedException {
        rates.clear();
        seconds.clear();
        WindowDriver.onEventThread(() -> {
            driver.window().model().adjust(beginning, this);
            pilot.replay();
        });
        while (WindowDriver.onEventThread(pilot::isReplaying)) {
            watch(SECOND, shown -> {});
        }
        // in the last one the ride ends
        rates.remove(rates.size() - 1);
        seconds.remove(seconds.size() - 1);
    }

    private void thrust(double sense) throws InterruptedException {
        Velocity before = driver.picture().studio().velocity();
        int answered = answers.size();
        long input = System.nanoTime();
        SwingUtilities.invokeLater(() -> pilot.setThrust(new Vector3d(0, 0, sense)));
        watch(THRUST_NANOSECONDS, shown -> {
            if (answers.size() == answered && !shown.studio().velocity().equals(before)) {
                answers.add((System.nanoTime() - input) * 1e-6);
            }
        });
        WindowDriver.onEventThread(pilot::stopThrust);
        // all pictures with thrust are on the screen
        Thread.sleep(COASTING_MILLISECONDS);
    }

    /** Counts pictures for a while, and keeps some of them. */
    private void watch(long nanoseconds, Consumer<Picture> listener) throws InterruptedException {
        WindowDriver.onEventThread(() -> {
            kept.clear();
            pictures = 0;
            start = System.nanoTime();
            length = nanoseconds;
            look = listener;
        });
        TimeUnit.NANOSECONDS.sleep(nanoseconds);
        WindowDriver.onEventThread(() -> {
            rates.add(pictures / ((System.nanoTime() - start) * 1e-9));
            seconds.add(List.copyOf(kept));
        });
    }

    private void count(ScreenPicture shown) {
        pictures++;
        look.accept(shown.now());
        if (kept.size() <= COMPARED * (System.nanoTime() - start) / length) {
            kept.add(shown);
        }
    }

    /** The differences to whole pictures: the root mean square of each second. */
    private List<Double> differences() throws InterruptedException {
        List<Double> differences = new ArrayList<>();
        try (Renderer renderer = new Renderer()) {
            for (List<ScreenPicture> second : seconds) {
                double sum = 0;
                for (ScreenPicture shown : second) {
                    LinearImage whole = renderer.render(shown.now().plan(), new Quality.Samples(1))
                            .image();
                    ToneCurve curve = shown.now().studio().settings().toneCurve();
                    double difference =
                            PictureDifference.ofLevels(shown.nowImage(), BufferedImages.toBufferedImage(whole, curve));
                    sum += difference * difference;
                }
                differences.add(Math.sqrt(sum / Math.max(1, second.size())));
            }
        }
        return differences;
    }

    private void print(String scene) throws InterruptedException {
        List<Double> differences = differences();
        System.out.printf(
                Locale.ROOT,
                "%s: %.1f %.1f %.2f %.2f%n",
                scene,
                Measure.median(rates),
                Measure.median(answers),
                Measure.median(differences),
                Collections.max(differences));
    }
}
