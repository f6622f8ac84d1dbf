package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every text that the window asks for is there, and none is there that nobody asks for. */
class TextsTest {

    private static final Path SOURCES = Path.of(System.getProperty("basedir", ""), "src/main/java/tompkins/ui");
    private static final Pattern LITERAL = Pattern.compile("\"([a-zA-Z0-9]+(?:\\.[a-zA-Z0-9_]*)*)\"");

    /** Literals in the sources: whole keys, and beginnings or ends from which keys are put together. */
    private static Set<String> literals() throws IOException {
        Set<String> literals = new TreeSet<>();
        try (Stream<Path> files = Files.list(SOURCES)) {
            for (Path file : files.toList()) {
                Matcher matcher = LITERAL.matcher(Files.readString(file));
                while (matcher.find()) {
                    literals.add(matcher.group(1));
                }
            }
        }
        return literals;
    }

    @Test
    void everyKeyInTheSourcesHasAText() throws IOException {
        List<String> missing = new ArrayList<>();
        Pattern use = Pattern.compile("Texts\\.get\\(\\s*\"([^\"]+)\"\\s*[,)]");
        try (Stream<Path> files = Files.list(SOURCES)) {
            for (Path file : files.toList()) {
                Matcher matcher = use.matcher(Files.readString(file));
                while (matcher.find()) {
                    if (!ResourceBundle.getBundle("tompkins.ui.Labels", Locale.ROOT)
                            .containsKey(matcher.group(1))) {
                        missing.add(file.getFileName() + ": " + matcher.group(1));
                    }
                }
            }
        }
        assertThat(missing).isEmpty();
    }

    @Test
    void noTextIsLeftOver() throws IOException {
        Set<String> literals = literals();
        List<String> unused = ResourceBundle.getBundle("tompkins.ui.Labels", Locale.ROOT).keySet().stream()
                .filter(key -> !literals.contains(key))
                .filter(key -> !literals.contains(key.replaceAll("Tip$", "")))
                .filter(key -> literals.stream().noneMatch(start -> start.endsWith(".") && key.startsWith(start)))
                .toList();
        assertThat(unused).isEmpty();
    }
}
