package tompkins.study;

/** Times something that is done over and over, after it has warmed up. */
final class Stopwatch {

    private static final long WARM_NANOS = 20_000_000;

    private Stopwatch() {}

    /** Runs a task until the compiler has settled; at least once. */
    static void warmUp(Runnable task) {
        long start = System.nanoTime();
        do {
            task.run();
        } while (System.nanoTime() - start < WARM_NANOS);
    }

    /** Seconds that a task takes. */
    static double seconds(Runnable task) {
        long start = System.nanoTime();
        task.run();
        return (System.nanoTime() - start) / 1e9;
    }
}
