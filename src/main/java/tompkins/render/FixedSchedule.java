package tompkins.render;

import java.util.Iterator;
import java.util.List;
import java.util.function.BooleanSupplier;

/** The passes of {@link Quality.Samples}. */
final class FixedSchedule implements Schedule {

    private final Iterator<Pass> passes;
    private final double allWork;

    FixedSchedule(List<Pass> passes) {
        this.passes = passes.iterator();
        allWork = passes.stream().mapToDouble(Pass::work).sum();
    }

    @Override
    public Pass next(BooleanSupplier stopped) {
        return passes.hasNext() ? passes.next() : null;
    }

    @Override
    public double progress(double work) {
        return work / allWork;
    }
}
