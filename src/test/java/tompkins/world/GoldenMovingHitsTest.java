package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;

/** Hits on what moves, seen and measured, against the reference data, row by row. */
class GoldenMovingHitsTest {

    private static final List<GoldenRow> SEEN = GoldenTable.rows("m1_hits");
    private static final List<GoldenRow> MEASURED = GoldenTable.rows("m7_measured_hits");

    @ParameterizedTest
    @EnumSource
    void seenHitsPassEveryRow(MovingQuantity quantity) {
        assertThat(Worst.of(SEEN, row -> quantity.excess(row, false))).matches(Worst::passes);
    }

    @ParameterizedTest
    @EnumSource
    void measuredHitsPassEveryRow(MovingQuantity quantity) {
        assertThat(Worst.of(MEASURED, row -> quantity.excess(row, true))).matches(Worst::passes);
    }
}
