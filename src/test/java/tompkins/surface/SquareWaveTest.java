package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SquareWaveTest {

    @ParameterizedTest
    @CsvSource({
        // a point, and a window within a tile
        "0.5, 0, 1",
        "1.5, 0, -1",
        "-0.5, 0, -1",
        "-1.5, 0, 1",
        "1e15, 0, 1",
        "1000000000000001, 0.25, 0",
        "0.3, 0.1, 1",
        // a point on an edge belongs to the tile above, whole tiles to themselves
        "0, 0, 1",
        "1, 0, -1",
        "2, 0, 1",
        "-1, 0, -1",
        "0.5, 0.5, 1",
        "1.5, 0.5, -1",
        // across an edge
        "1, 0.25, 0",
        "0.75, 0.5, 0.5",
        "0, 1e-300, 0",
        // whole periods, and half a tile more
        "0.123, 1, 0",
        "0.123, 1024, 0",
        "0.5, 1.5, -0.3333333333333333",
        "0.5, 1073741824.5, 4.656612870908797e-10",
        // the last odd number; beyond, numbers do not tell the values apart
        "9007199254740991, 0, -1",
        "-9007199254740991, 0, -1",
        "9007199254740992, 0, 0",
        "-9007199254740994, 0, 0",
        // without end
        "0.25, 1e300, 0",
        "1e300, 0, 0",
        "0, Infinity, 0",
        "NaN, 1, 0"
    })
    void meanOfAWindow(double centre, double half, double mean) {
        assertThat(SquareWave.mean(centre, half)).isCloseTo(mean, within(1e-15));
    }

    /** Against the sum over the tiles. */
    @Test
    void meanIsTheSumOfTheSharesOfTheTiles() {
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 2000; i++) {
            double centre = random.nextDouble(-20, 20);
            double half = random.nextDouble(1e-3, 10);
            double sum = 0;
            for (int tile = -40; tile < 40; tile++) {
                double overlap = Math.min(centre + half, tile + 1) - Math.max(centre - half, tile);
                sum += (tile % 2 == 0 ? 1 : -1) * Math.max(0, overlap);
            }
            assertThat(SquareWave.mean(centre, half)).isCloseTo(sum / (2 * half), within(2e-14 / half));
        }
    }
}
