package tompkins;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * What people copy to cite the program: the README for LaTeX, {@code docs/CITATION.cff} for programs, and the pom say
 * the same.
 */
class CitationTest {

    private static final Path PROJECT = Path.of(System.getProperty("basedir", ""));
    private static final Pattern BIBTEX_FIELD = Pattern.compile("(?s)(\\w+) = \\{(.*?)\\}(?=,\\n|\\n\\})");
    private static final Pattern CFF_FIELD = Pattern.compile("(?m)^ *(?:- )?([a-z-]+): *\"?(.+?)\"?$");

    private final String readme = read("README.md");
    private final String[] citation = read("docs/CITATION.cff").split("(?m)^references:$");

    CitationTest() throws IOException {}

    @Test
    void theProgramIsCitedAlike() throws IOException {
        Map<String, String> bibtex = bibtex("@software");
        Map<String, String> cff = fields(citation[0]);
        assertThat(cff.get("title")).isEqualTo(bibtex.get("title"));
        assertThat(cff.get("version")).isEqualTo(bibtex.get("version"));
        assertThat(cff.get("date-released")).startsWith(bibtex.get("year") + "-");
        assertThat("{" + cff.get("name") + "}").isEqualTo(bibtex.get("author"));
        String pom = read("pom.xml");
        assertThat(pom).contains("<version>" + cff.get("version") + "</version>\n  <packaging>");
        assertThat(pom).contains("<name>" + cff.get("license") + "</name>");
    }

    @Test
    void thePaperIsCitedAlike() {
        Map<String, String> bibtex = bibtex("@inproceedings");
        Map<String, String> cff = fields(citation[1]);
        assertThat(cff.get("title")).isEqualTo(bibtex.get("title"));
        assertThat(cff.get("collection-title")).isEqualTo(bibtex.get("booktitle"));
        assertThat(cff.get("volume")).isEqualTo(bibtex.get("volume"));
        assertThat(cff.get("start")).isEqualTo(bibtex.get("pages"));
        assertThat(cff.get("year")).isEqualTo(bibtex.get("year"));
        assertThat(cff.get("doi")).isEqualTo(bibtex.get("doi"));
        assertThat(authors(citation[1]))
                .hasSizeGreaterThan(1)
                .containsExactly(bibtex.get("author").split("\\s+and\\s+"));
    }

    private static List<String> authors(String reference) {
        return Pattern.compile("family-names: (.*)\\n +given-names: (.*)")
                .matcher(reference)
                .results()
                .map(name -> name.group(1) + ", " + name.group(2))
                .toList();
    }

    private Map<String, String> bibtex(String kind) {
        String entry = readme.substring(readme.indexOf(kind));
        return BIBTEX_FIELD
                .matcher(entry.substring(0, entry.indexOf("\n}") + 2))
                .results()
                .collect(Collectors.toMap(field -> field.group(1), field -> field.group(2)));
    }

    /** The first value of each key: those of the work stand before those of its authors. */
    private static Map<String, String> fields(String cff) {
        return CFF_FIELD
                .matcher(cff)
                .results()
                .collect(Collectors.toMap(field -> field.group(1), field -> field.group(2), (first, later) -> first));
    }

    private static String read(String file) throws IOException {
        return Files.readString(PROJECT.resolve(file));
    }
}
