package tompkins.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.golden.GoldenTable.U;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.math.Vectors;

/** Directions behind a thin lens against the reference data, row by row. */
class GoldenThinLensTest {

    private static final List<GoldenRow> ROWS =
            GoldenTable.rows("g_refraction_lens", row -> row.has("kind", "thin_lens"));

    @Test
    void programPassesEveryRow() {
        assertThat(Worst.of(
                        ROWS,
                        row -> excess(
                                row,
                                ThinLens.bend(
                                        Vectors.unit(row.vector("d")), axis(row), offset(row), row.number("power")))))
                .matches(Worst::passes);
    }

    @Test
    void placeAlongTheAxisDoesNotCount() {
        Vector3d d = new Vector3d(0.2, -0.3, 0.9).normalize();
        Vector3d axis = new Vector3d(2, -1, 2).div(3);
        Vector3d across = new Vector3d(1, 2, 0).mul(0.1);
        Vector3d expected = ThinLens.bend(d, axis, across, 0.7);
        Vector3d shifted = ThinLens.bend(d, axis, new Vector3d(axis).mul(5).add(across), 0.7);
        assertThat(shifted.distance(expected)).isLessThan(1e-14);
    }

    @Test
    void imagePositionFailsForObjectsInTheFocalPlane() {
        List<GoldenRow> inFocalPlane = ROWS.stream()
                .filter(row -> row.has("class", "object_in_focal_plane"))
                .toList();
        assertThat(Worst.of(inFocalPlane, row -> {
                            double focalLength = 1 / row.number("power");
                            return excess(
                                    row,
                                    NaiveThinLens.bend(
                                            row.vector("d"), axis(row), offset(row), row.number("power"), focalLength));
                        })
                        .excess())
                .isInfinite();
    }

    private static double excess(GoldenRow row, Vector3d direction) {
        return row.distance(direction.normalize(), "out") / (4 * U * row.number("acond_dir"));
    }

    private static Vector3d axis(GoldenRow row) {
        return Vectors.unit(row.vector("n"));
    }

    private static Vector3d offset(GoldenRow row) {
        return row.vector("x").sub(row.vector("c"));
    }
}
