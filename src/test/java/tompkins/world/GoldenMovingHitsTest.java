package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;

/** Hits on what moves, seen and measured, against the reference data, row by row. */
class GoldenMovingHitsTest {

    private static final List<GoldenRow> SEEN = GoldenTable.rows("m1_hits");
    private static final List<GoldenRow> MEASURED = GoldenTable.rows("m7_measured_hits");

    private static final IdentityHashMap<GoldenRow, Optional<FoundHit>> HITS = new IdentityHashMap<>();

    private static double excess(MovingQuantity quantity, GoldenRow row, boolean measures) {
        Optional<FoundHit> hit =
                HITS.computeIfAbsent(row, each -> Optional.ofNullable(MovingQuantity.find(each, measures)));
        return quantity.excess(row, hit.orElse(null), measures);
    }

    @ParameterizedTest
    @EnumSource
    void seenHitsPassEveryRow(MovingQuantity quantity) {
        assertThat(Worst.of(SEEN, row -> excess(quantity, row, false))).matches(Worst::passes);
    }

    @ParameterizedTest
    @EnumSource
    void measuredHitsPassEveryRow(MovingQuantity quantity) {
        assertThat(Worst.of(MEASURED, row -> excess(quantity, row, true))).matches(Worst::passes);
    }
}
