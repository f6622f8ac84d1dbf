package tompkins.image;

/**
 * How the rows and columns of a file lie in its picture, as the orientation tag of TIFF and Exif says (TIFF 6.0, page
 * 36). Each constant names the side on which the first row lies, and then the side of the first column.
 */
enum Orientation {
    TOP_LEFT(false, false, false),
    TOP_RIGHT(false, false, true),
    BOTTOM_RIGHT(false, true, true),
    BOTTOM_LEFT(false, true, false),
    LEFT_TOP(true, false, false),
    RIGHT_TOP(true, true, false),
    RIGHT_BOTTOM(true, true, true),
    LEFT_BOTTOM(true, false, true);

    private final boolean rowsUpright;
    private final boolean firstRowFar;
    private final boolean firstColumnFar;

    Orientation(boolean rowsUpright, boolean firstRowFar, boolean firstColumnFar) {
        this.rowsUpright = rowsUpright;
        this.firstRowFar = firstRowFar;
        this.firstColumnFar = firstColumnFar;
    }

    /** The orientation with a number of the tag; the usual one if the tag has no such number. */
    static Orientation ofTag(long number) {
        return number >= 1 && number <= values().length ? values()[(int) number - 1] : TOP_LEFT;
    }

    /**
     * The orientation in which the rows of the file are columns of the picture or not, the first of them lies at the
     * right or bottom or not, and so does the first pixel of each.
     */
    static Orientation of(boolean rowsUpright, boolean firstRowFar, boolean firstColumnFar) {
        for (Orientation orientation : values()) {
            if (orientation.rowsUpright == rowsUpright
                    && orientation.firstRowFar == firstRowFar
                    && orientation.firstColumnFar == firstColumnFar) {
                return orientation;
            }
        }
        throw new AssertionError("eight of eight cases are listed");
    }

    /** The picture whose rows a file has stored. */
    Pixels turn(Pixels stored) {
        if (this == TOP_LEFT) {
            return stored;
        }
        int rows = stored.height();
        int columns = stored.width();
        int width = rowsUpright ? rows : columns;
        int height = rowsUpright ? columns : rows;
        float[] from = stored.rgba();
        float[] to = new float[from.length];
        for (int row = 0; row < rows; row++) {
            int fromStart = firstRowFar ? rows - 1 - row : row;
            for (int column = 0; column < columns; column++) {
                int fromLeft = firstColumnFar ? columns - 1 - column : column;
                int pixel = rowsUpright ? fromLeft * width + fromStart : fromStart * width + fromLeft;
                System.arraycopy(from, 4 * (row * columns + column), to, 4 * pixel, 4);
            }
        }
        return new Pixels(width, height, to);
    }
}
