package tompkins.study;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** The time that a thread is at work, in which the other programs of the machine do not count. */
final class Stopwatch {

    private static final double WARM_SECONDS = 0.05;

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private Stopwatch() {}

    /** Seconds that this thread has been at work; real time where the machine does not tell. */
    private static double now() {
        return (THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime() : System.nanoTime())
                / 1e9;
    }

    /** Runs a task until the compiler has settled; at least once. */
    static void warmUp(Runnable task) {
        double start = now();
        do {
            task.run();
        } while (now() - start < WARM_SECONDS);
    }

    /** Seconds that a task takes. */
    static double seconds(Runnable task) {
        double start = now();
        task.run();
        return now() - start;
    }
}
