package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import javax.swing.JSlider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.Thorough;
import tompkins.studio.Studios;

/** Drags sliders and reports how long the event thread was busy with one event at most. */
@Timeout(300)
@NeedsDisplay
@Thorough
class EventThreadTest {

    private static final int DRAGS = 20;

    /** Of the processor, so that a busy computer does not fail; 3 are usual. A longer wait would be felt. */
    private static final long MOST_MILLISECONDS = 100;

    @Test
    void theEventThreadStaysFreeWhileSlidersAreDragged(@TempDir Path folder) {
        AtomicLong longest = new AtomicLong();
        try (WindowDriver driver = new WindowDriver(folder, Studios.lattice(), null, List.of())) {
            // what is loaded and compiled once is not meant
            drag(driver, driver.find(JSlider.class, "Speed, slider"));
            OwnEvents.EVENTS.watch(time -> longest.accumulateAndGet(time, Math::max));
            for (int i = 0; i < DRAGS; i++) {
                drag(driver, driver.find(JSlider.class, "Speed, slider"));
                drag(driver, driver.find(JSlider.class, "Opening time, slider"));
            }
            driver.completePicture();
        } finally {
            OwnEvents.EVENTS.watch(time -> {});
        }
        long milliseconds = longest.get() / 1_000_000;
        System.out.printf(Locale.ROOT, "longest event while dragging: %d ms of the processor%n", milliseconds);
        assertThat(longest).as("was watched").hasPositiveValue();
        assertThat(milliseconds).isLessThan(MOST_MILLISECONDS);
    }

    private static void drag(WindowDriver driver, JSlider slider) {
        Point middle = driver.centre(slider);
        int half = slider.getWidth() / 2 - 10;
        driver.drag(new Point(middle.x - half, middle.y), new Point(middle.x + half, middle.y), 40);
    }
}
