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

    private final CellLists cells;

    /** A map of unit vectors. */
    StarMap(List<Vector3d> directions) {
        x = directions.stream().mapToDouble(Vector3d::x).toArray();
        y = directions.stream().mapToDouble(Vector3d::y).toArray();
        z = directions.stream().mapToDouble(Vector3d::z).toArray();
        cells = new CellLists(
                CELLS * CELLS * CELLS,
                x.length,
                (star, cell) -> cell.accept(cell(step(x[star]), step(y[star]), step(z[star]))));
    }

    /** Takes the stars near a direction. */
    interface Visitor {

        /** Takes a star and its direction. */
        void take(int star, double starX, double starY, double starZ);
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
        for (int i = cells.begin(cell); i < cells.end(cell); i++) {
            int star = cells.number(i);
            double asideX = x[star] - dx;
            double asideY = y[star] - dy;
            double asideZ = z[star] - dz;
            double square = asideX * asideX + asideY * asideY + asideZ * asideZ;
            if (square < radius * radius) {
                visitor.take(star, x[star], y[star], z[star]);
            }
        }
    }

    private static int cell(int i, int j, int k) {
        return (i * CELLS + j) * CELLS + k;
    }

    private static int step(double coordinate) {
        return (int) Math.max(0, Math.min(CELLS - 1, (coordinate + 1) / 2 * CELLS));
    }
}
