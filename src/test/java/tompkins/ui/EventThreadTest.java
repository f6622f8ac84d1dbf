package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Toolkit;
import java.lang.management.ManagementFactory;
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

/** Drags sliders for ten seconds and reports how long the event thread was busy with one event at most. */
@Timeout(300)
@NeedsDisplay
@Thorough
class EventThreadTest {

    private static final long DRAG_NANOSECONDS = 10_000_000_000L;

    /** Of the processor, so that a busy computer does not fail; 3 are usual. A longer wait would be felt. */
    private static final long MOST_MILLISECONDS = 100;

    /** Notes the longest time, by the clock and of the processor, that one event took. */
    private static final class WatchedQueue extends EventQueue {

        private final AtomicLong longest = new AtomicLong();
        private final AtomicLong longestProcessor = new AtomicLong();

        @Override
        protected void dispatchEvent(AWTEvent event) {
            long start = System.nanoTime();
            long startProcessor = processorTime();
            super.dispatchEvent(event);
            longest.accumulateAndGet(System.nanoTime() - start, Math::max);
            longestProcessor.accumulateAndGet(processorTime() - startProcessor, Math::max);
        }

        private static long processorTime() {
            return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        }

        /** Gives way to the queue before it; called by the event thread. */
        void leave() {
            pop();
        }

        void forget() {
            longest.set(0);
            longestProcessor.set(0);
        }
    }

    @Test
    void theEventThreadStaysFreeWhileSlidersAreDragged(@TempDir Path folder) {
        WatchedQueue queue = new WatchedQueue();
        WindowDriver.onEventThread(
                () -> Toolkit.getDefaultToolkit().getSystemEventQueue().push(queue));
        try (WindowDriver driver = new WindowDriver(folder, Studios.lattice(), null, List.of())) {
            drag(driver, driver.find(JSlider.class, "Speed, slider"));
            queue.forget();
            long end = System.nanoTime() + DRAG_NANOSECONDS;
            while (System.nanoTime() < end) {
                drag(driver, driver.find(JSlider.class, "Speed, slider"));
                drag(driver, driver.find(JSlider.class, "Opening time, slider"));
            }
            driver.completePicture();
        } finally {
            WindowDriver.onEventThread(() -> queue.leave());
        }
        assertThat(Toolkit.getDefaultToolkit().getSystemEventQueue()).isNotSameAs(queue);
        System.out.printf(
                Locale.ROOT,
                "longest event while dragging: %d ms by the clock, %d ms of the processor%n",
                queue.longest.get() / 1_000_000,
                queue.longestProcessor.get() / 1_000_000);
        assertThat(queue.longestProcessor.get() / 1_000_000).isLessThan(MOST_MILLISECONDS);
    }

    private static void drag(WindowDriver driver, JSlider slider) {
        Point middle = driver.centre(slider);
        int half = slider.getWidth() / 2 - 10;
        driver.drag(new Point(middle.x - half, middle.y), new Point(middle.x + half, middle.y), 40);
    }
}
