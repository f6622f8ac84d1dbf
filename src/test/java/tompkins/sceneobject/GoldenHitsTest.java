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

/** Distances of hits against the reference data, row by row. */
class GoldenHitsTest {

    @ParameterizedTest
    @ValueSource(strings = {"sphere", "plane", "cylinder"})
    void programPassesEveryRow(String shape) {
        List<GoldenRow> rows = GoldenTable.rows(GoldenHits.FILE, row -> row.has("shape", shape));
        assertThat(GoldenHits.worst(rows, HitMethod.PROGRAM)).matches(Worst::passes);
    }

    @ParameterizedTest
    @CsvSource({
        "sphere, far_small",
        "sphere, sky_overflow",
        "sphere, self_in",
        "plane, near_plane",
        "cylinder, parallel_inside",
        "cylinder, far_thin",
        "cylinder, grazing"
    })
    void naiveFormFails(String shape, String kind) {
        List<GoldenRow> rows =
                GoldenTable.rows(GoldenHits.FILE, row -> row.has("shape", shape) && row.has("class", kind));
        assertThat(GoldenHits.worst(rows, new NaiveHits()).excess()).isGreaterThan(1);
    }

    @Test
    void everyKindOfRowIsRun() {
        assertThat(GoldenTable.rows(GoldenHits.FILE))
                .extracting(row -> row.text("shape"))
                .containsOnly("sphere", "plane", "cylinder");
    }
}
