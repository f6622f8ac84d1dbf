package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.golden.GoldenTable.U;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.math.Vectors;

/** Refracted directions against the reference data, row by row. */
class GoldenRefractionTest {

    private static final List<GoldenRow> ROWS =
            GoldenTable.rows("g_refraction_lens", row -> row.has("kind", "refraction"));

    @Test
    void programPassesEveryRow() {
        assertThat(Worst.of(ROWS, row -> {
                    Vector3d result = new Vector3d();
                    double cosine =
                            Refraction.bend(unit(row, "d"), unit(row, "n"), row.number("n1"), row.number("n2"), result);
                    return excess(row, result, cosine == 0);
                }))
                .matches(Worst::passes);
    }

    /** Where even 16 u decide between transmission and total reflection, only the decision may differ. */
    private static double excess(GoldenRow row, Vector3d direction, boolean reflected) {
        boolean decidable = row.number("decidable_eps") >= 16 * U;
        if (reflected != row.has("tir", "1")) {
            return decidable ? Double.POSITIVE_INFINITY : 0;
        }
        return row.distance(direction, "out") / (4 * U * row.number("acond_dir"));
    }

    private static Vector3d unit(GoldenRow row, String prefix) {
        return Vectors.unit(row.vector(prefix));
    }
}
