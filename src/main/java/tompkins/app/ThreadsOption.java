package tompkins.app;

import picocli.CommandLine.Option;
import tompkins.property.MistakeException;
import tompkins.property.Require;

/** How many threads a command uses. */
final class ThreadsOption {

    /** More than the cores of any machine, and not so many that systems refuse to start them. */
    private static final int MOST = 1024;

    @Option(names = "--threads", paramLabel = "N", description = "number of threads; default: one per core")
    private Long threads;

    /** The number that was given, or that of the cores. */
    int number() {
        return threads == null
                ? Runtime.getRuntime().availableProcessors()
                : MistakeException.inOption("--threads", () -> Require.within("threads", threads, 1, MOST));
    }
}
