package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PixelVarianceTest {

    private static final int WIDTH = 20;
    private static final int HEIGHT = 40;

    /** Among rows that several threads share as well: of each column one pixel is wrong by 1/sqrt(12). */
    @ParameterizedTest
    @ValueSource(ints = {6, 7, 8, 9, 15, 16, 17, 20, 24, 32})
    void anEdgeCountsAlikeInEveryRow(int edge) {
        Film film = new Film(WIDTH, HEIGHT, 1, false);
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            double light = pixel / WIDTH < edge ? 0 : 1;
            Films.add(film, pixel, light, light, light, 1);
        }

        double error = new PixelVariance(film, () -> false).rootMeanSquare();

        assertThat(error).isCloseTo(Math.sqrt(1.0 / 12 / HEIGHT), within(1e-7));
    }
}
