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

/** Sheets of lessons hold what readers need, and the answers only on the last page. */
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

    @Test
    void theAnswersAreOnTheLastPage() throws IOException {
        assertThat(sheet().code()).isZero();

        String[] sections = sections();
        assertThat(sections).hasSize(4);
        String answer = "&#x2611; ";
        assertThat(sections[1]).contains("What", "Penrose 1959", "&#x2610; ").doesNotContain(answer);
        assertThat(sections[2]).contains("<th>measured").doesNotContain(answer, "3.45", "5.73");
        assertThat(sections[3]).contains(answer, "3.4509", "5.7392");
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

        String page = String.join("", sections());
        assertThat(page)
                .contains("<title>&lt;script&gt;alert(&#39;&quot;&amp; &#39;)&lt;/script&gt;</title>")
                .contains("<p>&lt;/p&gt;&lt;img src=x&gt;</p>")
                .doesNotContain("<script", "<img src=x");
    }

    @Test
    void formulasHavePrintedSigns() throws IOException {
        assertThat(sheet("--set", "lesson.numbers[0].formula=sqrt(1 - v)").code())
                .isZero();
        assertThat(sections()[3]).contains("<td>\u221a(1 - v)<td>");
    }

    @Test
    void nothingIsReplacedAndALessonIsNeeded() throws IOException {
        Path sheet = Files.writeString(folder.resolve("sheet.html"), "mine");
        ProgramRun run = sheet();
        assertThat(run.code()).isEqualTo(Failures.MISTAKE);
        assertThat(run.err()).contains("sheet.html: there is a file of this name already; --force replaces it");
        assertThat(sheet).hasContent("mine");
        assertThat(sheet("--force").code()).isZero();
        assertThat(sections()).hasSize(4);

        Path ball = Files.writeString(folder.resolve("ball.json"), "{\"scene\": [{\"type\": \"Sphere\"}]}");
        ProgramRun none = ProgramRun.of("sheet", ball, "-o", folder.resolve("ball.html"));
        assertThat(none.code()).isEqualTo(Failures.MISTAKE);
        assertThat(none.err()).contains("ball.json: the scene must have a lesson");
        assertThat(folder.resolve("ball.html")).doesNotExist();

        ProgramRun paper = ProgramRun.of("sheet", LESSON, "-o", folder.resolve("sheet.pdf"));
        assertThat(paper.code()).isEqualTo(Failures.MISTAKE);
        assertThat(paper.err()).contains("sheet.pdf: the name of a sheet must end in .html");
        assertThat(folder.resolve("sheet.pdf")).doesNotExist();
    }
}
