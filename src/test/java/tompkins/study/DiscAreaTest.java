package tompkins.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

/** Compares the closed forms with sums over fine grids, and with values known from geometry. */
class DiscAreaTest {

    @Test
    void knownShares() {
        assertThat(DiscArea.below(0)).isEqualTo(0.5);
        assertThat(DiscArea.below(2)).isEqualTo(1);
        assertThat(DiscArea.below(-2)).isEqualTo(0, within(1e-16));
        // a segment of 120 degrees: (2 pi/3 - sin(120))/2 of the area pi is cut off
        assertThat(DiscArea.below(0.5))
                .isEqualTo(1 - (2 * Math.PI / 3 - Math.sqrt(3) / 2) / (2 * Math.PI), within(1e-15));
        assertThat(DiscArea.below(0, 0.7, 1.1)).isEqualTo(0.5, within(1e-14));
        assertThat(DiscArea.below(9, 0.7, 1.1)).isEqualTo(1, within(1e-13));
    }

    @Test
    void sharesOfGrids() {
        SplittableRandom random = new SplittableRandom(5);
        for (ExactProblem problem : ExactProblems.OF_LENS) {
            for (int i = 0; i < 4; i++) {
                ExactProblem.Instance instance = problem.instances().apply(random);
                double sum = gridMean(problem.space().hasPixel(), instance.integrand());
                assertThat(instance.exact()).as("%s %d", problem.key(), i).isEqualTo(sum, within(3e-3));
            }
        }
    }

    /** The mean over a grid on the lens and, if wanted, in the pixel; wrong by at most a part of a cell along edges. */
    private static double gridMean(boolean pixelToo, ToDoubleFunction<Position> integrand) {
        int lens = pixelToo ? 100 : 600;
        int pixel = pixelToo ? 12 : 1;
        Position position = new Position();
        double sum = 0;
        int count = 0;
        for (int i = 0; i < lens * lens; i++) {
            position.lensX = (i % lens + 0.5) / lens * 2 - 1;
            position.lensY = (i / lens + 0.5) / lens * 2 - 1;
            if (position.lensX * position.lensX + position.lensY * position.lensY > 1) {
                continue;
            }
            for (int j = 0; j < pixel * pixel; j++) {
                position.x = (j % pixel + 0.5) / pixel;
                position.y = (j / pixel + 0.5) / pixel;
                sum += integrand.applyAsDouble(position);
                count++;
            }
        }
        return sum / count;
    }
}
