package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.IntFunction;

/**
 * Methods that do the same work in turns, so that whatever else the machine does disturbs them all alike. It is run
 * when the first of its results is wanted.
 */
final class Race {

    private final Map<String, IntFunction<Figures>> methods;
    private final int repeats;
    private Map<String, Figures> results;

    /**
     * A race.
     *
     * @param methods the figures of a run of each method, by the number of the run; warming up is run 0
     * @param repeats number of runs
     */
    Race(Map<String, IntFunction<Figures>> methods, int repeats) {
        this.methods = methods;
        this.repeats = repeats;
    }

    /** The trials of all methods. */
    List<Trial> trials(String problem, double setting) {
        return methods.keySet().stream()
                .map(method -> new Trial(problem, method, setting, () -> result(method)))
                .toList();
    }

    private Figures result(String method) {
        if (results == null) {
            results = run();
        }
        return results.get(method);
    }

    private Map<String, Figures> run() {
        methods.values().forEach(method -> Stopwatch.warmUp(() -> Objects.requireNonNull(method.apply(0))));
        Map<String, List<Figures>> runs = new LinkedHashMap<>();
        for (int run = 1; run <= repeats; run++) {
            for (Map.Entry<String, IntFunction<Figures>> method : methods.entrySet()) {
                runs.computeIfAbsent(method.getKey(), first -> new ArrayList<>())
                        .add(method.getValue().apply(run));
            }
        }
        Map<String, Figures> figures = new LinkedHashMap<>();
        runs.forEach((method, all) -> figures.put(method, Figures.of(all)));
        return figures;
    }
}
