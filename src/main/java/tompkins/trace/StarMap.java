package tompkins.trace;

import java.util.List;
import org.joml.Vector3d;

/**
 * Directions of stars, sorted into the cells of a cube, so that those near a direction are found fast. Immutable,
 * shared by all threads.
 */
final class StarMap {

    /** Cells along an edge of the cube from -1 to 1. */
    private static final int CELLS = 20;

    private final double[] x;
    private final double[] y;
    private final double[] z;

    /** The stars of each cell, one cell after the other. */
    private final int[] stars;

    /** Where those of each cell begin. */
    private final int[] begins = new int[CELLS * CELLS * CELLS + 1];

    /** A map of unit vectors. */
    StarMap(List<Vector3d> directions) {
        x = directions.stream().mapToDouble(Vector3d::x).toArray();
        y = directions.stream().mapToDouble(Vector3d::y).toArray();
        z = directions.stream().mapToDouble(Vector3d::z).toArray();
        for (int star = 0; star < x.length; star++) {
            begins[cell(star) + 1]++;
        }
        for (int cell = 0; cell + 1 < begins.length; cell++) {
            begins[cell + 1] += begins[cell];
        }
        stars = new int[x.length];
        int[] next = begins.clone();
        for (int star = 0; star < x.length; star++) {
            stars[next[cell(star)]++] = star;
        }
    }

    /** Takes the stars near a direction. */
    interface Visitor {

        /**
         * Takes a star, and the square of its distance from the direction, which is that of the angle if it is small.
         */
        void take(int star, double square);
    }

    /** Visits all stars whose distance from a unit vector is below a radius. */
    void visit(double dx, double dy, double dz, double radius, Visitor visitor) {
        int right = step(dx + radius);
        int top = step(dy + radius);
        int far = step(dz + radius);
        for (int i = step(dx - radius); i <= right; i++) {
            for (int j = step(dy - radius); j <= top; j++) {
                for (int k = step(dz - radius); k <= far; k++) {
                    visitCell(cell(i, j, k), dx, dy, dz, radius, visitor);
                }
            }
        }
    }

    private void visitCell(int cell, double dx, double dy, double dz, double radius, Visitor visitor) {
        for (int i = begins[cell]; i < begins[cell + 1]; i++) {
            int star = stars[i];
            double asideX = x[star] - dx;
            double asideY = y[star] - dy;
            double asideZ = z[star] - dz;
            double square = asideX * asideX + asideY * asideY + asideZ * asideZ;
            if (square < radius * radius) {
                visitor.take(star, square);
            }
        }
    }

    private int cell(int star) {
        return cell(step(x[star]), step(y[star]), step(z[star]));
    }

    private static int cell(int i, int j, int k) {
        return (i * CELLS + j) * CELLS + k;
    }

    private static int step(double coordinate) {
        return (int) Math.max(0, Math.min(CELLS - 1, (coordinate + 1) / 2 * CELLS));
    }
}
