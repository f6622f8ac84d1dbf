package tompkins.study;

import java.util.function.Supplier;

/**
 * A measurement that can be made.
 *
 * @param problem see {@link Measurement#problem()}
 * @param method see {@link Measurement#method()}
 * @param setting see {@link Measurement#setting()}
 * @param measurer finds the figures
 * @param work what it shares with other trials, such as a reference; all of them are best measured by one process
 */
public record Trial(String problem, String method, double setting, Supplier<Figures> measurer, Object work) {

    /** A trial that shares nothing. */
    Trial(String problem, String method, double setting, Supplier<Figures> measurer) {
        this(problem, method, setting, measurer, measurer);
    }

    /** Makes the measurement. */
    Measurement measure() {
        Figures found = measurer.get();
        return new Measurement(
                problem, method, setting, found.rays(), found.seconds(), found.error(), found.maximum(), found.floor());
    }

    /** Whether a measurement comes from this trial. */
    boolean made(Measurement measurement) {
        return measurement.problem().equals(problem)
                && measurement.method().equals(method)
                && measurement.setting() == setting;
    }
}
