package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TileTest {

    @ParameterizedTest
    @CsvSource({"1,1", "31,33", "32,32", "100,7", "65535,1", "640,480"})
    void tilesCoverEachPixelOnce(int width, int height) {
        int[] covered = new int[width * height];

        for (Tile tile : Tile.of(width, height)) {
            for (int row = tile.row(); row < tile.row() + tile.height(); row++) {
                for (int column = tile.column(); column < tile.column() + tile.width(); column++) {
                    covered[row * width + column]++;
                }
            }
        }

        assertThat(covered).containsOnly(1);
    }

    /** Coarse passes sample every 8th pixel, counted from the corner of the picture. */
    @Test
    void tilesBeginAtMultiplesOfTheirSize() {
        assertThat(Tile.of(1000, 700)).allMatch(tile -> tile.column() % 32 == 0 && tile.row() % 32 == 0);
    }

    @Test
    void tilesGoFromTheCentreOutwards() {
        assertThat(Tile.of(160, 96))
                .startsWith(new Tile(64, 32, 32, 32))
                .last()
                .matches(tile -> tile.column() % 128 == 0 && tile.row() % 64 == 0);
    }
}
