package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
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

    @Test
    void theFirstTileLiesInTheMiddleAndTheLastInACorner() {
        List<Tile> tiles = Tile.of(160, 96);

        assertThat(tiles.get(0)).isEqualTo(new Tile(64, 32, 32, 32));
        Tile last = tiles.get(tiles.size() - 1);
        assertThat(last.column()).isIn(0, 128);
        assertThat(last.row()).isIn(0, 64);
    }

    /** Coarse passes sample every 8th pixel, counted from the corner of the picture. */
    @Test
    void tilesBeginAtMultiplesOfTheirSize() {
        assertThat(Tile.of(1000, 700)).allMatch(tile -> tile.column() % 32 == 0 && tile.row() % 32 == 0);
    }

    /** Those of a forecast are half as wide, so that some do not begin where a tile of a picture does. */
    @Test
    void smallTilesGetEachSampleOnce() {
        int side = 80;
        int[] taken = new int[side * side];

        for (Pass pass : Pass.of(20, 20, false)) {
            for (Tile tile : Tile.of(side, side, 16)) {
                for (int row = tile.row(); row < tile.row() + 16; row += pass.stride()) {
                    for (int column = tile.column(); column < tile.column() + 16; column += pass.stride()) {
                        taken[row * side + column] += pass.takes(column, row, 0) ? pass.samples() : 0;
                    }
                }
            }
        }

        assertThat(taken).containsOnly(20);
    }
}
