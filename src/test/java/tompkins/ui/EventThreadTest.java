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
import tompkins.ProcessorTime;
import tompkins.Thorough;
import tompkins.render.Renderer;
import tompkins.studio.Studios;
import tompkins.trace.RenderPlan;

/** Drags sliders and reports how long the event thread was busy with one event at most. */
@Timeout(300)
@NeedsDisplay
@Thorough
class EventThreadTest {

    private static final int DRAGS = 20;

    /** Of the processor time that the picture takes, so that a busy or slow computer does not fail; 1/50 is usual. */
    private static final double MOST = 0.25;

    @Test
    void theEventThreadStaysFreeWhileSlidersAreDragged(@TempDir Path folder) throws InterruptedException {
        AtomicLong longest = new AtomicLong();
        double picture;
        try (WindowDriver driver = new WindowDriver(folder, Studios.lattice(), null, List.of())) {
            // what is loaded and compiled once is not meant
            drag(driver, driver.find(JSlider.class, "Speed, slider"));
            OwnEvents.EVENTS.watch(time -> longest.accumulateAndGet(time, Math::max));
            for (int i = 0; i < DRAGS; i++) {
                drag(driver, driver.find(JSlider.class, "Speed, slider"));
                drag(driver, driver.find(JSlider.class, "Opening time, slider"));
            }
            driver.completePicture();
            RenderPlan plan = RenderPlan.of(driver.studioOnScreen());
            try (Renderer renderer = new Renderer(1)) {
                picture = ProcessorTime.ofProcess(() -> renderer.render(plan));
            }
        } finally {
            OwnEvents.EVENTS.watch(time -> {});
        }
        double event = longest.get() * 1e-9;
        System.out.printf(Locale.ROOT, "longest event while dragging: %.3f s, a picture: %.3f s%n", event, picture);
        assertThat(event).as("was watched").isPositive().isLessThan(MOST * picture);
    }

    private static void drag(WindowDriver driver, JSlider slider) {
        Point middle = driver.centre(slider);
        int half = slider.getWidth() / 2 - 10;
        driver.drag(new Point(middle.x - half, middle.y), new Point(middle.x + half, middle.y), 40);
    }
}
