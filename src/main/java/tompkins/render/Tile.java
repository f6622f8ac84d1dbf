package tompkins.render;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * A rectangle of pixels that one thread renders at a time.
 *
 * @param column first column
 * @param row first row
 * @param width number of columns
 * @param height number of rows
 */
record Tile(int column, int row, int width, int height) {

    /** Width and height of a tile, away from the edges of the picture. */
    static final int SIZE = 32;

    /** The tiles of a picture, from the centre outwards. */
    static List<Tile> of(int pictureWidth, int pictureHeight) {
        return of(pictureWidth, pictureHeight, SIZE);
    }

    /** Tiles of another width and height, from the centre outwards. */
    static List<Tile> of(int pictureWidth, int pictureHeight, int size) {
        List<Tile> tiles = new ArrayList<>();
        for (int row = 0; row < pictureHeight; row += size) {
            for (int column = 0; column < pictureWidth; column += size) {
                tiles.add(new Tile(
                        column, row, Math.min(size, pictureWidth - column), Math.min(size, pictureHeight - row)));
            }
        }
        tiles.sort(Comparator.comparingLong(tile -> tile.fromCentre(pictureWidth, pictureHeight)));
        return tiles;
    }

    /** Four times the square of the distance between its centre and that of the picture. */
    private long fromCentre(int pictureWidth, int pictureHeight) {
        long across = 2L * column + width - pictureWidth;
        long down = 2L * row + height - pictureHeight;
        return across * across + down * down;
    }

    /** Number of pixels. */
    int pixels() {
        return width * height;
    }
}
