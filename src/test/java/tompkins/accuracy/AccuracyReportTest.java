package tompkins.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Keeps docs/accuracy.md true: {@value AccuracyReport#COMMAND} writes it again. */
class AccuracyReportTest {

    private static final Path FILE = Path.of(System.getProperty("basedir", ""), "docs", "accuracy.md");

    /** Measured numbers may differ between machines by this factor. */
    private static final double FACTOR = 4;

    private static final Pattern NUMBER = Pattern.compile("(?<=\\| )(\\d+\\.\\d+(e[+-]\\d+)?|none|no number)(?= )");

    @Test
    void fileHolds() throws IOException {
        String measured = AccuracyReport.markdown();
        if (Boolean.getBoolean("tompkins.regenerate")) {
            Files.writeString(FILE, measured + explanations());
        }
        String committed = Files.readString(FILE);
        assertThat(committed).as("run " + AccuracyReport.COMMAND).startsWith("# Accuracy\n");
        List<String> claims = numbers(committed);
        List<String> found = numbers(measured);
        assertThat(NUMBER.matcher(committed.substring(0, reportEnd(committed))).replaceAll("#"))
                .as("run " + AccuracyReport.COMMAND)
                .isEqualTo(NUMBER.matcher(measured).replaceAll("#"));
        assertThat(found).hasSizeGreaterThan(40);
        for (int i = 0; i < found.size(); i++) {
            assertThat(isNear(claims.get(i), found.get(i)))
                    .as("number %d: %s in the file, %s measured", i, claims.get(i), found.get(i))
                    .isTrue();
        }
    }

    /** The section on what turns is written by hand, behind the report. */
    private static String explanations() throws IOException {
        String old = Files.exists(FILE) ? Files.readString(FILE) : "";
        return old.isEmpty() ? "" : old.substring(reportEnd(old));
    }

    private static int reportEnd(String text) {
        int end = text.indexOf("\n## Turning objects");
        return end < 0 ? text.length() : end;
    }

    private static List<String> numbers(String text) {
        List<String> numbers = new ArrayList<>();
        Matcher matcher = NUMBER.matcher(text.substring(0, reportEnd(text)));
        while (matcher.find()) {
            numbers.add(matcher.group());
        }
        return numbers;
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
            assertThat(comparison.ours()).matches(worst -> worst.passes());
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
