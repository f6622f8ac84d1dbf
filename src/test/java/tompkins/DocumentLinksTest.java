package tompkins;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.io.SelfDescription;
import tompkins.ui.widget.Texts;

/**
 * The links of the documents lead to files and headings that are there, and the first page lists and cites what there
 * is.
 */
class DocumentLinksTest {

    private static final Path BASE = Path.of(System.getProperty("basedir", ""));
    private static final Pattern LINK = Pattern.compile("\\]\\(([^()\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#{1,6} +(.+?) *#*$");

    static Stream<Path> documents() throws IOException {
        try (Stream<Path> pages = Files.list(BASE.resolve("docs"))) {
            List<Path> all =
                    new ArrayList<>(pages.filter(page -> page.toString().endsWith(".md"))
                            .sorted()
                            .toList());
            all.add(BASE.resolve("README.md"));
            return all.stream();
        }
    }

    @ParameterizedTest
    @MethodSource("documents")
    void everyRelativeLinkLeadsSomewhere(Path document) throws IOException {
        List<String> broken = new ArrayList<>();
        for (String link : links(document)) {
            if (!leadsSomewhere(document, link)) {
                broken.add(link);
            }
        }
        assertThat(broken).isEmpty();
    }

    /** The first page groups them as the list of all pages does, which the window shows. */
    @Test
    void everyPageIsInBothLists() throws IOException {
        List<String> list = links(BASE.resolve("docs/README.md"));
        // before the list stand those with which one may begin
        List<String> all = list.subList(list.lastIndexOf("tour.md"), list.size());
        assertThat(documents().map(page -> page.getFileName().toString()).filter(name -> !name.equals("README.md")))
                .containsExactlyInAnyOrderElementsOf(all);
        List<String> first = links(BASE.resolve("README.md"));
        assertThat(first.subList(first.indexOf("docs/README.md") + 1, first.size()))
                .startsWith(all.stream().map(name -> "docs/" + name).toArray(String[]::new));
    }

    @Test
    void theCitationIsThatOfTheWindow() throws IOException {
        assertThat(Files.readString(BASE.resolve("README.md")))
                .contains("```bibtex\n" + Texts.get("help.bibtex", SelfDescription.version()) + "```\n");
    }

    @Test
    void brokenLinksAreFound() {
        Path readme = BASE.resolve("README.md");
        assertThat(leadsSomewhere(readme, "docs/no-such-page.md")).isFalse();
        assertThat(leadsSomewhere(readme, "docs/window.md#no-such-heading")).isFalse();
        assertThat(leadsSomewhere(readme, "docs/window.md#wrong-values")).isTrue();
    }

    /** What the links and pictures of a page lead to; blocks of code have none. */
    private static List<String> links(Path document) throws IOException {
        String text =
                Files.readString(document).replaceAll("(?ms)^```.*?^```", "").replaceAll("`[^`\n]*`", "");
        return LINK.matcher(text).results().map(link -> link.group(1)).toList();
    }

    private static boolean leadsSomewhere(Path document, String link) {
        if (link.matches("[a-z]+:.*")) {
            return true;
        }
        String[] parts = link.split("#", 2);
        Path target = parts[0].isEmpty()
                ? document
                : document.resolveSibling(URLDecoder.decode(parts[0], StandardCharsets.UTF_8));
        return Files.exists(target) && (parts.length == 1 || anchors(target).contains(parts[1]));
    }

    /**
     * The names that headings get where pages are shown: small letters, hyphens for spaces, numbers for repetitions.
     */
    private static List<String> anchors(Path page) {
        try {
            Map<String, Integer> seen = new HashMap<>();
            List<String> anchors = new ArrayList<>();
            Matcher heading = HEADING.matcher(Files.readString(page).replaceAll("(?ms)^```.*?^```", ""));
            while (heading.find()) {
                String anchor = heading.group(1)
                        .toLowerCase(Locale.ROOT)
                        .replaceAll("[^\\p{L}\\p{N} _-]", "")
                        .replace(' ', '-');
                int before = seen.merge(anchor, 1, Integer::sum) - 1;
                anchors.add(before == 0 ? anchor : anchor + "-" + before);
            }
            return anchors;
        } catch (IOException unreadable) {
            throw new AssertionError(unreadable);
        }
    }
}
