package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.TestRun;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;

/** Surfaces at one place are met one after the other, as with a gap that nobody sees; media there are one boundary. */
class TouchingSurfacesTest {

    private static final int RAYS = 400;

    static LongStream pairs() {
        return LongStream.range(0, TestRun.cases(70, 3500));
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void touchingLooksAsWithAGap(long number) {
        TouchingPair pair = TouchingPair.of(number);
        assertThat(differing(pair)).as(pair.name()).isLessThanOrEqualTo(RAYS / 1000);
    }

    /** How many rays bring other light; negative if the pair takes more than three times as many rays. */
    static int differing(TouchingPair pair) {
        RayCounts counts = new RayCounts();
        RayCounts otherCounts = new RayCounts();
        SampleTracer tracer = RenderPlan.of(pair.touching()).tracer(counts);
        SampleTracer other = RenderPlan.of(pair.other()).tracer(otherCounts);
        SplittableRandom random = new SplittableRandom(5);
        int differing = 0;
        for (int i = 0; i < RAYS; i++) {
            double x = random.nextDouble(64);
            double y = random.nextDouble(64);
            differing += isSame(tracer.sample(x, y, 0, 0, 0.5), other.sample(x, y, 0, 0, 0.5)) ? 0 : 1;
        }
        assertThat(counts.rays).as("rays of %s", pair.name()).isLessThanOrEqualTo(3 * otherCounts.rays);
        return differing;
    }

    private static boolean isSame(Colour one, Colour other) {
        return Math.abs(one.red() - other.red()) < 1e-6
                && Math.abs(one.green() - other.green()) < 1e-6
                && Math.abs(one.blue() - other.blue()) < 1e-6;
    }
}
