package tompkins.study;

import java.util.function.Supplier;

/**
 * A measurement that can be made.
 *
 * @param problem see {@link StudyPoint#problem()}
 * @param method see {@link StudyPoint#method()}
 * @param setting see {@link StudyPoint#setting()}
 * @param measurer finds the figures
 */
public record Trial(String problem, String method, double setting, Supplier<Figures> measurer) {

    /** Makes the measurement. */
    public StudyPoint measure() {
        Figures found = measurer.get();
        return new StudyPoint(
                problem, method, setting, found.rays(), found.seconds(), found.error(), found.maximum(), found.floor());
    }
}
