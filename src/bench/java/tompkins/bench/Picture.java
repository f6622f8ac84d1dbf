package tompkins.bench;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.LongStream;
import tompkins.render.RenderJob;
import tompkins.render.RenderReport;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** One picture that is taken again and again by a number of threads. */
final class Picture implements AutoCloseable {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private final Studio studio;
    private final Renderer renderer;
    private final List<Double> milliseconds = new ArrayList<>();
    private RenderPlan plan;
    private RenderReport report;
    private double bytesPerSample;

    Picture(Studio studio, int threads) {
        this.studio = studio;
        renderer = new Renderer(threads);
    }

    /**
     * Takes the picture some times, from the plan to the last pixel; the prepared scene is taken over, as the window
     * does.
     */
    void take(int times) throws InterruptedException {
        for (int i = 0; i < times; i++) {
            take();
        }
    }

    private void take() throws InterruptedException {
        long bytes = allocated();
        long start = System.nanoTime();
        plan = RenderPlan.of(studio, plan);
        RenderJob job = renderer.render(plan);
        milliseconds.add((System.nanoTime() - start) / 1e6);
        report = job.report();
        bytesPerSample = (double) (allocated() - bytes) / report.counts().samples;
    }

    /** Bytes that the rendering threads of this process allocated so far. */
    private static long allocated() {
        long[] ids = Arrays.stream(THREADS.getThreadInfo(THREADS.getAllThreadIds()))
                .filter(thread -> thread != null && thread.getThreadName().equals("tompkins-render"))
                .mapToLong(ThreadInfo::getThreadId)
                .toArray();
        return LongStream.of(THREADS.getThreadAllocatedBytes(ids))
                .filter(bytes -> bytes > 0)
                .sum();
    }

    /** The median time, of the second half of the pictures: the compiler has settled then. */
    double median() {
        return Measure.median(milliseconds.subList(milliseconds.size() / 2, milliseconds.size()));
    }

    RenderReport report() {
        return report;
    }

    double bytesPerSample() {
        return bytesPerSample;
    }

    @Override
    public void close() {
        renderer.close();
    }
}
