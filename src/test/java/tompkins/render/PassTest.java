package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PassTest {

    @ParameterizedTest
    @CsvSource({"1,true", "1,false", "2,true", "7,false", "64,true", "100,false", "1000,true"})
    void passesTakeEachSampleOfEachPixelOnce(int samples, boolean coarseFirst) {
        int side = 80;
        int[][] taken = new int[side * side][samples];

        for (Pass pass : Pass.of(samples, samples, coarseFirst)) {
            // the parts of a forecast are smaller than the tiles of a picture
            for (Tile part : Tile.of(side, side, 16)) {
                for (int row = 0; row < 16; row += pass.stride()) {
                    for (int column = 0; column < 16; column += pass.stride()) {
                        take(pass, part.column() + column, part.row() + row, side, taken);
                    }
                }
            }
        }

        assertThat(Arrays.stream(taken).flatMapToInt(Arrays::stream)).containsOnly(1);
    }

    private static void take(Pass pass, int column, int row, int side, int[][] taken) {
        for (int i = 0; i < pass.samples() && pass.takes(column, row, 0); i++) {
            taken[row * side + column][Math.max(0, pass.firstSample()) + i]++;
        }
    }

    @ParameterizedTest
    @CsvSource({"1,true", "1,false", "5,true", "64,false", "300,true"})
    void workAddsUpToTheSamples(int samples, boolean coarseFirst) {
        double work = Pass.of(samples, samples, coarseFirst).stream()
                .mapToDouble(Pass::work)
                .sum();

        assertThat(work).isCloseTo(samples, within(1e-12 * samples));
    }

    @ParameterizedTest
    @CsvSource({
        "1,'32:1,1:1'",
        "5,'32:5,1:5'",
        "50,'32:16,1:16,1:16,1:18'",
        "200,'32:16,1:16,1:16,1:32,1:64,1:64,1:8'",
        "700,'32:16,1:16,1:16,1:32,1:64,1:64,1:64,1:64,1:64,1:64,1:64,1:64,1:72,1:52'"
    })
    void passesDoubleTheSamplesAndThenGrowByAnEighth(int samples, String expected) {
        List<String> sizes = Pass.of(samples, samples, false).stream()
                .map(pass -> pass.stride() + ":" + pass.samples())
                .toList();

        assertThat(String.join(",", sizes)).isEqualTo(expected);
    }

    /** Whoever watches sees a sample of each pixel, coarse to fine, and then ever longer passes. */
    @Test
    void passesThatAreWatchedBeginWithFewSamples() {
        assertThat(Pass.of(9, 9, true).stream().map(pass -> pass.stride() + ":" + pass.samples()))
                .containsExactly("8:1", "4:1", "2:1", "1:1", "1:1", "1:2", "1:4", "1:1");
    }
}
