package tompkins.search;

import tompkins.search.LightBufferProjection.Rectangle;

/**
 * What a cell of a lamp's view says about a primitive, in one number: the upper half of the bits holds a lower bound of
 * its distance from the lamp, the lower half the rectangle of parts of the cell in which it is seen. Few bytes matter:
 * a shadow ray among a million primitives looks at dozens of entries that are no longer in the processor's cache.
 *
 * <p>Each side of the rectangle has a byte, and so has the place of a ray. A ray passes a side if the two bytes add up
 * to the highest bit; one addition tests all four sides.
 */
final class BufferEntry {

    private static final int LAST = LightBufferProjection.PARTS - 1;

    /** The highest bit of each byte. */
    private static final int ALL_SIDES = 0x80808080;

    private BufferEntry() {}

    /** The entry of a primitive in the cell of a column and row. */
    static long of(float leastDistance, Rectangle rectangle, int column, int row) {
        int firstColumn = Math.max(0, rectangle.firstColumn() - column * LightBufferProjection.PARTS);
        int lastColumn = Math.min(LAST, rectangle.lastColumn() - column * LightBufferProjection.PARTS);
        int firstRow = Math.max(0, rectangle.firstRow() - row * LightBufferProjection.PARTS);
        int lastRow = Math.min(LAST, rectangle.lastRow() - row * LightBufferProjection.PARTS);
        int sides = bytes(LAST - firstColumn, lastColumn, LAST - firstRow, lastRow);
        return (long) Float.floatToIntBits(leastDistance) << Integer.SIZE | sides;
    }

    /** The place of a ray in its cell, in the form in which entries compare it with their rectangles. */
    static int place(int part) {
        int column = part & LAST;
        int row = part >> Short.SIZE & LAST;
        return bytes(column + 1, LightBufferProjection.PARTS - column, row + 1, LightBufferProjection.PARTS - row);
    }

    private static int bytes(int first, int second, int third, int fourth) {
        return first << 24 | second << 16 | third << 8 | fourth;
    }

    /** Whether the primitive of an entry may be seen at a place. */
    static boolean isSeen(long entry, int place) {
        return ((int) entry + place & ALL_SIDES) == ALL_SIDES;
    }

    /** A distance from the lamp in the form in which entries compare it with theirs. */
    static int distance(double distance) {
        return Float.floatToIntBits(Math.nextUp((float) distance));
    }

    /** Whether the primitive of an entry surely lies farther from the lamp. */
    static boolean isFarther(long entry, int distance) {
        return (int) (entry >>> Integer.SIZE) > distance;
    }
}
