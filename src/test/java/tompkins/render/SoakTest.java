package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import tompkins.Thorough;
import tompkins.fuzz.RandomStudio;
import tompkins.trace.RenderPlan;

/**
 * Many renders, cancelled at random moments, leave nothing behind. Long form: {@code mvn test -Dtest=SoakTest
 * -Dtompkins.soak=1000}.
 */
@Thorough
class SoakTest {

    private static final int RENDERS = Integer.getInteger("tompkins.soak", 100);
    private static final long MEMORY = 16 << 20;

    @Test
    void cancelledRendersLeaveNoThreadAndNoMemory() throws InterruptedException {
        SplittableRandom random = new SplittableRandom(3);
        Set<Thread> others = renderThreads();
        long before = 0;
        for (int i = 0; i < RENDERS; i++) {
            renderAndCancel(random.nextInt(3_000_000), i);
            if (i == RENDERS / 4) {
                before = usedMemory();
            }
        }
        Set<Thread> left = renderThreads();
        left.removeAll(others);
        for (Thread thread : left) {
            thread.join(5000);
        }
        assertThat(left).noneMatch(Thread::isAlive);
        assertThat(usedMemory() - before).isLessThan(MEMORY);
    }

    private static void renderAndCancel(int nanoseconds, int seed) throws InterruptedException {
        CountDownLatch ended = new CountDownLatch(1);
        try (Renderer renderer = new Renderer(2)) {
            var studio = RandomStudio.of(seed);
            RenderJob job = renderer.start(
                    RenderPlan.of(studio.withSettings(studio.settings().withSize(320, 240))),
                    new Quality.Samples(64),
                    new RenderListener() {
                        @Override
                        public void ended(RenderJob job) {
                            ended.countDown();
                        }
                    });
            TimeUnit.NANOSECONDS.sleep(nanoseconds);
            job.cancel();
            assertThat(ended.await(20, TimeUnit.SECONDS))
                    .as("render %d ends soon", seed)
                    .isTrue();
            assertThat(job.isCancelled() || job.isComplete()).isTrue();
        }
    }

    private static Set<Thread> renderThreads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("tompkins-render"))
                .collect(Collectors.toSet());
    }

    private static long usedMemory() {
        Runtime runtime = Runtime.getRuntime();
        for (int i = 0; i < 3; i++) {
            System.gc();
        }
        return runtime.totalMemory() - runtime.freeMemory();
    }
}
