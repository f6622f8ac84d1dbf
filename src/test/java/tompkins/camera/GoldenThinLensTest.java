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
import tompkins.shutter.LensRay;

/** Directions behind a thin lens against the reference data, row by row. */
class GoldenThinLensTest {

    private static final List<GoldenRow> ROWS =
            GoldenTable.rows("g_refraction_lens", row -> row.has("kind", "thin_lens"));

    @Test
    void programPassesEveryRow() {
        assertThat(Worst.of(ROWS, row -> excess(row, bend(row)))).matches(Worst::passes);
    }

    /** By the traced direction of the ray through the same point of a lens that is focused by the power of this one. */
    private static Vector3d bend(GoldenRow row) {
        Vector3d chief = Vectors.unit(row.vector("d"));
        Vector3d axis = axis(row);
        double inverseFocusDistance = row.number("power") * Math.abs(chief.dot(axis));
        return new LensRay(row.vector("c"), row.vector("x"), chief, inverseFocusDistance, axis).towardsFocus();
    }

    private static double excess(GoldenRow row, Vector3d direction) {
        return row.distance(direction.normalize(), "out") / (4 * U * row.number("acond_dir"));
    }

    private static Vector3d axis(GoldenRow row) {
        return Vectors.unit(row.vector("n"));
    }
}
