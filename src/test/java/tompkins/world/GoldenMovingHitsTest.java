package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
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

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void naiveFormFails(boolean measures) {
        List<GoldenRow> rows = (measures ? MEASURED : SEEN)
                .stream()
                        .filter(row -> row.has("law", "lorentz"))
                        .filter(row -> row.has("hit", "1") && !row.has("shape", "cylinder"))
                        .toList();

        assertThat(Worst.of(
                                rows,
                                row -> MovingQuantity.share(
                                        row, row.difference(NaiveMotion.lambda(row, measures), "lambda"), "lambda"))
                        .excess())
                .isGreaterThan(1e3);
        // it is the same hit: where nothing is fast, the naive form will do
        assertThat(Worst.of(
                        rows.stream()
                                .filter(row -> row.text("class").equals("both_move"))
                                .toList(),
                        row -> row.relativeDifference(NaiveMotion.lambda(row, measures), "lambda") / 1e-9))
                .matches(Worst::passes);
    }
}
