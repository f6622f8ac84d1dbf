package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every text that the window asks for is there, and none is there that nobody asks for. */
class TextsTest {

    private static final Path SOURCES = Path.of(System.getProperty("basedir", ""), "src/main/java/tompkins/ui");
    private static final Pattern USE = Pattern.compile("Texts\\.get\\(\\s*\"([^\"]+)\"\\s*[,)]");

    /** Whole keys, and beginnings or ends from which keys are put together. */
    private static final Pattern LITERAL = Pattern.compile("\"([a-zA-Z0-9]+(?:\\.[a-zA-Z0-9_]*)*)\"");

    private static final Set<String> KEYS =
            ResourceBundle.getBundle("tompkins.ui.Labels", Locale.ROOT).keySet();

    /** What the first group of a pattern is, wherever the sources of the window have it. */
    private static Set<String> found(Pattern pattern) throws IOException {
        Set<String> found = new TreeSet<>();
        try (Stream<Path> files = Files.walk(SOURCES)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                pattern.matcher(Files.readString(file)).results().forEach(match -> found.add(match.group(1)));
            }
        }
        return found;
    }

    @Test
    void everyKeyInTheSourcesHasAText() throws IOException {
        assertThat(found(USE)).hasSizeGreaterThan(100).isSubsetOf(KEYS);
    }

    @Test
    void noTextIsLeftOver() throws IOException {
        Set<String> literals = found(LITERAL);
        List<String> unused = KEYS.stream()
                .filter(key -> !literals.contains(key))
                .filter(key -> !literals.contains(key.replaceAll("Tip$", "")))
                .filter(key -> literals.stream().noneMatch(start -> start.endsWith(".") && key.startsWith(start)))
                .toList();
        assertThat(unused).isEmpty();
    }
}
