package tompkins.study;

import java.util.ArrayList;
import java.util.List;

/** Collects the figures of repeated runs of one trial. */
final class Repeats {

    private final List<ErrorNorm> norms = new ArrayList<>();
    private final List<Double> seconds = new ArrayList<>();

    void add(ErrorNorm norm, double time) {
        norms.add(norm);
        seconds.add(time);
    }

    Measurement measurement(String problem, String method, double setting, double rays, double floor) {
        return new Measurement(
                problem,
                method,
                setting,
                rays,
                Spread.of(seconds.stream().mapToDouble(Double::doubleValue).toArray()),
                Spread.of(norms.stream().mapToDouble(ErrorNorm::rootMeanSquare).toArray()),
                Spread.of(norms.stream().mapToDouble(ErrorNorm::maximum).toArray())
                        .middle(),
                floor);
    }
}
