package tompkins.study;

import java.util.function.Supplier;

/**
 * A measurement that can be made.
 *
 * @param problem see {@link Measurement#problem()}
 * @param method see {@link Measurement#method()}
 * @param setting see {@link Measurement#setting()}
 * @param measurer finds the figures
 */
public record Trial(String problem, String method, double setting, Supplier<Figures> measurer) {

    /** Makes the measurement. */
    public Measurement measure() {
        Figures found = measurer.get();
        return new Measurement(
                problem, method, setting, found.rays(), found.seconds(), found.error(), found.maximum(), found.floor());
    }
}
