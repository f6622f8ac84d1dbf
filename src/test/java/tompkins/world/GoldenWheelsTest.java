package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;

/** Points and shapes that turn, seen and measured, against the reference data, row by row. */
class GoldenWheelsTest {

    private static final List<GoldenRow> ROWS = GoldenTable.rows("m11_wheels");

    @ParameterizedTest
    @EnumSource
    void wheelsPassEveryRow(WheelQuantity quantity) {
        assertThat(Worst.of(ROWS, quantity::excess)).matches(Worst::passes);
    }
}
