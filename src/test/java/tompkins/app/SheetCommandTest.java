package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sheets of lessons hold what readers need, and the answers are in a file of their own. */
class SheetCommandTest {

    private static final Path LESSON = Path.of(System.getProperty("basedir", ""), "scenes/lesson-01-round-ball.json");

    @TempDir
    private Path folder;

    private ProgramRun sheet(Object... more) {
        return ProgramRun.of(List.of("sheet", LESSON, "-o", folder.resolve("sheet.html"), "--size", "80x20"), more);
    }

    private String[] sections() throws IOException {
        return Files.readString(folder.resolve("sheet.html")).split("<section>");
    }

    private String answers() throws IOException {
        return Files.readString(folder.resolve("sheet-answers.html"));
    }

    @Test
    void theAnswersAreInAFileOfTheirOwn() throws IOException {
        ProgramRun run = sheet();
        assertThat(run.code()).isZero();
        assertThat(run.out().lines())
                .satisfiesExactly(
                        first -> assertThat(first).endsWith("sheet.html"),
                        second -> assertThat(second).endsWith("sheet-answers.html"));

        String[] sections = sections();
        assertThat(sections).hasSize(3);
        String answer = "&#x2611; ";
        assertThat(sections[1]).contains("What", "Penrose 1959", "&#x2610; ").doesNotContain(answer);
        assertThat(sections[2]).contains("<th>measured").doesNotContain(answer, "3.45", "5.73");
        assertThat(answers()).contains(answer, "3.4509", "5.7392").doesNotContain("<img");
    }

    /** Each page of lesson 5 shows both times, and that of lesson 18 both ends of the way home. */
    @Test
    void severalLessonsShowAllPicturesThatAreMeasured() throws IOException {
        Path fast = LESSON.resolveSibling("lesson-05-faster-than-light.json");
        Path twins = LESSON.resolveSibling("lesson-18-twins.json");
        Path sheet = folder.resolve("sheet.html");
        assertThat(ProgramRun.of("sheet", fast, twins, "-o", sheet, "--size", "40x20")
                        .code())
                .isZero();

        String[] sections = sections();
        assertThat(sections).hasSize(5);
        assertThat(captions(sections[1])).containsExactly("Time of the photograph: 10000");
        assertThat(captions(sections[2]))
                .containsExactly("Time of the photograph: 10005", "Time of the photograph: 10006");
        assertThat(captions(sections[4]))
                .containsExactly(
                        "Your watch on the way out (min): 3",
                        "On the ride, after 3 by the clock on board",
                        "On the ride, after 6 by the clock on board");
        assertThat(answers()).contains("Answers: Lesson 5, Lesson 18", "3.042", "10 minutes.");
    }

    private static List<String> captions(String section) {
        return Pattern.compile("<figcaption>([^<]*)</figcaption>")
                .matcher(section)
                .results()
                .map(found -> found.group(1))
                .toList();
    }

    /** The picture is in the page, and holds no scene, in which the answers are. */
    @Test
    void thePictureIsInThePage() throws IOException {
        assertThat(sheet().code()).isZero();

        String page = String.join("", sections());
        Matcher data = Pattern.compile("src=\"data:image/png;base64,([A-Za-z0-9+/=]+)\"")
                .matcher(page);
        assertThat(data.find()).isTrue();
        byte[] png = Base64.getDecoder().decode(data.group(1));
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(png));
        assertThat(picture.getWidth()).isEqualTo(80);
        String question = data.group(1);
        assertThat(data.find()).as("and the one in which is measured").isTrue();
        assertThat(data.group(1)).isNotEqualTo(question);
        assertThat(data.find()).isFalse();
        assertThat(new String(png, StandardCharsets.ISO_8859_1)).doesNotContain("reveal");
        assertThat(page).doesNotContain("http://", "https://", "<script", "<link");
    }

    @Test
    void textsOfTheLessonAreNoTags() throws IOException {
        assertThat(sheet("--set", "title=<script>alert('\"&\u202e')</script>", "--set", "lesson.reveal=</p><img src=x>")
                        .code())
                .isZero();

        String title = "&lt;script&gt;alert(&#39;&quot;&amp; &#39;)&lt;/script&gt;</title>";
        assertThat(String.join("", sections())).contains("<title>" + title).doesNotContain("<script");
        assertThat(answers())
                .contains("<title>Answers: " + title, "<p>&lt;/p&gt;&lt;img src=x&gt;</p>")
                .doesNotContain("<script", "<img src=x");
    }

    @Test
    void formulasHavePrintedSigns() throws IOException {
        assertThat(sheet("--set", "lesson.numbers[0].formula=sqrt(1 - v)").code())
                .isZero();
        assertThat(answers()).contains("<td>\u221a(1 - v)<td>");
    }

    @Test
    void nothingIsReplaced() throws IOException {
        Path sheet = Files.writeString(folder.resolve("sheet.html"), "mine");
        ProgramRun run = sheet();
        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err()).contains("sheet.html: there is a file of this name already; --force replaces it");
        assertThat(sheet).hasContent("mine");
        assertThat(folder.resolve("sheet-answers.html")).doesNotExist();
        assertThat(sheet("--force").code()).isZero();
        assertThat(sections()).hasSize(3);
        Files.delete(sheet);
        ProgramRun answered = sheet();
        assertThat(answered.code()).isEqualTo(Failures.MISTAKE);
        assertThat(answered.err()).contains("sheet-answers.html: there is a file of this name already");
        assertThat(sheet).doesNotExist();
    }
}
