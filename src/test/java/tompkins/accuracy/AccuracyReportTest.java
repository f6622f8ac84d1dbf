package tompkins.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import tompkins.golden.Worst;

/** Keeps the numbers in the tables of docs/accuracy.md true. */
class AccuracyReportTest {

    private static final Path FILE = Path.of(System.getProperty("basedir", ""), "docs", "accuracy.md");

    private static final String COMMAND = "mvn -q test -Dtest=AccuracyReportTest -Dtompkins.regenerate=true";

    /** Measured numbers may differ between machines by this factor. */
    private static final double FACTOR = 4;

    private static final Pattern NUMBER = Pattern.compile("(?<=\\| )(\\d+\\.\\d+(e[+-]\\d+)?|none|no number)(?= )");

    @Test
    void tablesHold() throws IOException {
        Map<String, String> measured = AccuracyReport.rows().stream()
                .collect(Collectors.toMap(AccuracyReportTest::withoutNumbers, Function.identity()));
        if (Boolean.getBoolean("tompkins.regenerate")) {
            Files.write(
                    FILE,
                    Files.readAllLines(FILE).stream()
                            .map(line -> measured.getOrDefault(withoutNumbers(line), line))
                            .toList());
        }
        List<String> claimed = Files.readAllLines(FILE).stream()
                .filter(line -> measured.containsKey(withoutNumbers(line)))
                .toList();

        assertThat(claimed).as("rows with other words; run " + COMMAND).hasSize(measured.size());
        assertThat(claimed).allSatisfy(row -> {
            List<String> claims = numbers(row);
            List<String> found = numbers(measured.get(withoutNumbers(row)));
            for (int i = 0; i < claims.size(); i++) {
                assertThat(isNear(claims.get(i), found.get(i)))
                        .as("%s: %s measured; run %s", row, found.get(i), COMMAND)
                        .isTrue();
            }
        });
    }

    private static String withoutNumbers(String line) {
        return NUMBER.matcher(line).replaceAll("#");
    }

    private static List<String> numbers(String line) {
        return NUMBER.matcher(line).results().map(MatchResult::group).toList();
    }

    private static boolean isNear(String claim, String found) {
        if (claim.startsWith("no") || found.startsWith("no")) {
            return claim.equals(found) || tiny(claim) && tiny(found);
        }
        double ratio = Double.parseDouble(claim) / Double.parseDouble(found);
        return ratio <= FACTOR && ratio >= 1 / FACTOR || tiny(claim) && tiny(found);
    }

    /** No error at all, or one of the last bit. */
    private static boolean tiny(String number) {
        return number.equals("none") || !number.startsWith("no") && Double.parseDouble(number) < 1e-15;
    }

    @Test
    void programIsWithinAllLimitsAndTheNaiveFormsAreNot() {
        assertThat(AccuracyReport.Comparison.all()).allSatisfy(comparison -> {
            assertThat(comparison.ours()).matches(Worst::passes);
            assertThat(comparison.naive().excess()).isGreaterThan(1);
        });
    }

    @Test
    void programDoesBetterInEveryFailureMode() {
        assertThat(FailureMode.all()).allSatisfy(mode -> {
            assertThat(mode.ours()).isLessThan(1e-3);
            assertThat(mode.naive()).isGreaterThan(5 * mode.ours());
        });
    }
}
