package tompkins.app;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.FutureTask;
import picocli.CommandLine.Option;
import tompkins.property.MistakeException;
import tompkins.property.Require;

/** How many threads a command uses. */
final class ThreadsOption {

    /** More than the cores of any machine, and not so many that systems refuse to start them. */
    private static final int MOST = 1024;

    @Option(names = "--threads", paramLabel = "N", description = "number of threads; default: one per core")
    private Long threads;

    /** Does work whose parallel streams use so many threads. */
    <T> T during(Callable<T> work) throws Exception {
        ForkJoinPool pool = new ForkJoinPool(number());
        FutureTask<T> task = new FutureTask<>(work);
        pool.execute(task);
        try {
            return task.get();
        } catch (ExecutionException failed) {
            if (failed.getCause() instanceof Error error) {
                throw error;
            }
            throw (Exception) failed.getCause();
        } finally {
            pool.shutdown();
        }
    }

    /** The number that was given, or that of the cores. */
    int number() {
        return threads == null
                ? Runtime.getRuntime().availableProcessors()
                : MistakeException.inOption("--threads", () -> Require.within("threads", threads, 1, MOST));
    }
}
