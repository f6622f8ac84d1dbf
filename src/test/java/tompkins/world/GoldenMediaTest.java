package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;
import static tompkins.golden.GoldenTable.U;

import java.util.IdentityHashMap;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;

/** What is seen in media that move, against the reference data, row by row, to gamma 1e6. */
class GoldenMediaTest {

    private static final List<GoldenRow> ROWS = GoldenTable.rows("m9_media");

    private static boolean isDecidable(GoldenRow row) {
        return row.number("decidable_eps") >= 16 * U;
    }

    private static final IdentityHashMap<GoldenRow, MediumRow> MEDIA = new IdentityHashMap<>();

    private static MediumRow medium(GoldenRow row) {
        return MEDIA.computeIfAbsent(row, MediumRow::new);
    }

    private static List<GoldenRow> seen() {
        return ROWS.stream()
                .filter(row -> !row.has("images", "0"))
                .filter(row -> isDecidable(row) || !row.text("class").equals("edge"))
                .toList();
    }

    @ParameterizedTest
    @EnumSource
    void quantityPassesEveryRow(MediumQuantity quantity) {
        assertThat(Worst.of(seen(), row -> quantity.excess(row, medium(row)))).matches(Worst::passes);
    }

    /** Nothing, one thing or two are seen in a direction. */
    @Test
    void asManyImagesAreSeenInEveryRow() {
        assertThat(ROWS).filteredOn(GoldenMediaTest::isDecidable).allSatisfy(row -> {
            MediumRow medium = medium(row);
            int images = (medium.met == null ? 0 : 1) + (medium.overtaken == null ? 0 : 1);
            assertThat(row.text("images")).isEqualTo(Integer.toString(images));
        });
    }
}
