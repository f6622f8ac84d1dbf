package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;

/** Hits of cones and boxes against the reference data, row by row. */
class GoldenSolidsTest {

    @ParameterizedTest
    @ValueSource(strings = {"cone", "box"})
    void programPassesEveryRow(String shape) {
        List<GoldenRow> rows = GoldenTable.rows(GoldenSolids.FILE, row -> row.has("shape", shape));
        assertThat(GoldenSolids.worstDistance(rows, HitMethod.PROGRAM)).matches(Worst::passes);
    }

    @Test
    void programPassesEveryNormal() {
        assertThat(GoldenSolids.worstNormal(HitMethod.PROGRAM)).matches(Worst::passes);
    }

    @ParameterizedTest
    @CsvSource({
        "cone, far",
        "cone, tip",
        "cone, grazing",
        "cone, slender",
        "cone, flat",
        "cone, along_mantle",
        "cone, self_out",
        "box, floor",
        "box, room"
    })
    void naiveFormFails(String shape, String kind) {
        List<GoldenRow> rows =
                GoldenTable.rows(GoldenSolids.FILE, row -> row.has("shape", shape) && row.has("class", kind));
        assertThat(GoldenSolids.worstDistance(rows, new NaiveHits()).excess()).isGreaterThan(1);
    }
}
