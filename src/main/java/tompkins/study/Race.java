package tompkins.study;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;

/** Methods that do the same work in turns, so that whatever else the machine does disturbs them all alike. */
final class Race {

    private static final double WARM_SECONDS = 0.05;

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private Race() {}

    /**
     * The trials of all methods; they are run when the first of the results is wanted.
     *
     * @param methods the figures of a run of each method, by the number of the run; warming up is run 0
     * @param repeats number of runs
     */
    static List<Trial> trials(String problem, double setting, Map<String, IntFunction<Figures>> methods, int repeats) {
        Map<String, List<Figures>> runs = new LinkedHashMap<>();
        return methods.keySet().stream()
                .map(method -> new Trial(problem, method, setting, () -> {
                    if (runs.isEmpty()) {
                        run(methods, repeats, runs);
                    }
                    return Figures.of(runs.get(method));
                }))
                .toList();
    }

    private static void run(Map<String, IntFunction<Figures>> methods, int repeats, Map<String, List<Figures>> runs) {
        for (IntFunction<Figures> method : methods.values()) {
            // until the compiler has settled
            double start = now();
            do {
                Figures unused = method.apply(0);
            } while (now() - start < WARM_SECONDS);
        }
        for (int run = 1; run <= repeats; run++) {
            for (Map.Entry<String, IntFunction<Figures>> method : methods.entrySet()) {
                runs.computeIfAbsent(method.getKey(), first -> new ArrayList<>())
                        .add(method.getValue().apply(run));
            }
        }
    }

    /** Seconds of a task, in which the other programs of the machine do not count where it tells. */
    static double seconds(Runnable task) {
        double start = now();
        task.run();
        return now() - start;
    }

    private static double now() {
        return (THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime() : System.nanoTime())
                / 1e9;
    }
}
