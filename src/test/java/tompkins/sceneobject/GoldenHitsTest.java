package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;

/** Hits against the reference data, row by row. */
class GoldenHitsTest {

    @ParameterizedTest
    @ValueSource(strings = {"sphere", "plane", "cylinder"})
    void programPassesEveryRow(String shape) {
        List<GoldenRow> rows = GoldenTable.rows(GoldenHits.FILE, row -> row.has("shape", shape));

        assertThat(GoldenHits.worst(rows, HitMethod.PROGRAM)).matches(Worst::passes);
    }

    @ParameterizedTest
    @ValueSource(strings = {"cone", "box"})
    void solidsPassEveryRow(String shape) {
        List<GoldenRow> rows = GoldenTable.rows(GoldenSolids.FILE, row -> row.has("shape", shape));

        assertThat(GoldenSolids.worstDistance(rows, HitMethod.PROGRAM)).matches(Worst::passes);
    }

    @Test
    void conesPassEveryNormal() {
        assertThat(GoldenSolids.worstNormal(HitMethod.PROGRAM)).matches(Worst::passes);
    }
}
