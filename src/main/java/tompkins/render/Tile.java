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
        List<Tile> tiles = new Tile(0, 0, pictureWidth, pictureHeight).parts(size);
        tiles.sort(Comparator.comparingLong(tile -> tile.fromCentre(pictureWidth, pictureHeight)));
        return tiles;
    }

    /** Its parts of a width and height, row by row. */
    List<Tile> parts(int size) {
        List<Tile> parts = new ArrayList<>();
        for (int down = 0; down < height; down += size) {
            for (int right = 0; right < width; right += size) {
                parts.add(new Tile(
                        column + right, row + down, Math.min(size, width - right), Math.min(size, height - down)));
            }
        }
        return parts;
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
