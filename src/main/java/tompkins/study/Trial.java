package tompkins.study;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * A measurement that can be made.
 *
 * @param problem see {@link Measurement#problem()}
 * @param method see {@link Measurement#method()}
 * @param setting see {@link Measurement#setting()}
 * @param measurer makes it
 */
public record Trial(String problem, String method, double setting, Measurer measurer) {

    /** Makes a measurement. */
    @FunctionalInterface
    public interface Measurer {

        /**
         * Makes it.
         *
         * @param cancelled asked now and then
         * @throws CancellationException soon after {@code cancelled} became true
         */
        Measurement measure(BooleanSupplier cancelled);
    }

    /** Whether a measurement is that of this trial. */
    boolean made(Measurement measurement) {
        return measurement.problem().equals(problem)
                && measurement.method().equals(method)
                && measurement.setting() == setting;
    }
}
