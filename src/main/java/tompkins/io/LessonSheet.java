package tompkins.io;

import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonControl;
import tompkins.lesson.Prediction;
import tompkins.measure.LessonResult;
import tompkins.property.NumberText;
import tompkins.property.OneLine;

/**
 * A lesson to be printed: question and picture, room to write, and on the last page the answers. The page is one file
 * that loads nothing from elsewhere; all texts of the lesson are letters in it and never tags.
 *
 * @param title title of the scene
 * @param remarks what there is to know about the picture
 * @param lesson the lesson
 * @param png the picture that is seen with the question
 * @param measured the picture in which is measured
 * @param results what the program measures
 */
public record LessonSheet(
        String title, String remarks, Lesson lesson, byte[] png, byte[] measured, List<LessonResult> results) {

    private static final String STYLE = """
            @page { margin: 2cm }
            body { font: 11pt/1.45 serif; max-width: 17cm; margin: auto }
            section { break-after: page }
            section:last-child { break-after: auto }
            img { display: block; max-width: 100%; max-height: 11cm; margin: 0.6cm auto }
            .line { border-bottom: 1px solid #888; height: 0.9cm }
            table { border-collapse: collapse; width: 100% }
            th, td { border: 1px solid #888; padding: 0.15cm 0.25cm; text-align: left; vertical-align: top }
            """;

    private static final int LINES = 5;

    /** The page. */
    public String html() {
        return String.format(Locale.ROOT, """
                <!DOCTYPE html>
                <html lang="en">
                <head>
                <meta charset="utf-8">
                <meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
                <title>%s</title>
                <style>
                %s</style>
                </head>
                <body>
                <section>
                %s</section>
                <section>
                %s</section>
                <section>
                %s</section>
                </body>
                </html>
                """, text(title), STYLE, question(), measuring(), answers());
    }

    private String question() {
        return tag("h1", text(title))
                + tag("p", text(lesson.question()))
                + picture("The picture of the question", png)
                + tag("p", text(FactText.readable(remarks)))
                + lesson.shuffled().stream()
                        .map(prediction -> tag("p", "&#x2610; " + text(prediction.text())))
                        .collect(Collectors.joining())
                + tag("p", "I am &#x2610; sure, &#x2610; not sure, because")
                + lines(LINES);
    }

    private String measuring() {
        LessonControl control = lesson.control();
        return tag("h2", "Look, and measure")
                + tag(
                        "p",
                        "This is the picture at " + NumberText.of(control.measuredAt()) + " for "
                                + tag("b", text(control.name())).strip() + "; that of the question is at "
                                + NumberText.of(control.from()) + ". What do you see? Why is it so?")
                + picture("The picture in which is measured", measured)
                + lines(LINES)
                + tag("p", "Work the numbers out, and measure as many as you can in the picture.")
                + tag("p", text(FactText.readable(lesson.letters())))
                + table(
                        "<th>number<th>worked out<th>measured",
                        results.stream()
                                .map(result -> "<td>" + text(result.number().name()) + unit(result) + "<td><td>")
                                .toList());
    }

    private String answers() {
        return tag("h2", "Answers: " + text(title))
                + lesson.shuffled().stream().map(this::answer).collect(Collectors.joining())
                + tag("p", text(FactText.readable(lesson.reveal())))
                + tag("p", text(FactText.readable(lesson.law())))
                + table(
                        "<th>number<th>formula<th>worked out<th>measured by the program",
                        results.stream()
                                .map(result -> "<td>" + text(result.number().name()) + unit(result) + "<td>"
                                        + text(FactText.readable(result.number().formula())) + "<td>"
                                        + FactText.readable(result.predictedText()) + "<td>"
                                        + text(FactText.readable(result.measuredText())))
                                .toList());
    }

    private String answer(Prediction prediction) {
        String sign = lesson.isRight(prediction) ? "&#x2611; " : "&#x2610; ";
        return tag("p", sign + tag("b", text(prediction.text())).strip() + " " + text(prediction.reply()));
    }

    private static String unit(LessonResult result) {
        String unit = result.number().unit();
        return unit.isEmpty() ? "" : " (" + text(unit) + ")";
    }

    private static String picture(String name, byte[] png) {
        return "<img alt=\"" + name + "\" src=\"data:image/png;base64,"
                + Base64.getEncoder().encodeToString(png) + "\">\n";
    }

    private static String lines(int count) {
        return "<div class=\"line\"></div>\n".repeat(count);
    }

    private static String table(String heading, List<String> rows) {
        return tag(
                "table",
                "\n<tr>" + heading + "\n"
                        + rows.stream().map(row -> "<tr>" + row + "\n").collect(Collectors.joining()));
    }

    private static String tag(String name, String content) {
        return "<" + name + ">" + content + "</" + name + ">\n";
    }

    /** A text of the lesson as letters of the page. */
    private static String text(String written) {
        return OneLine.of(written)
                .replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;")
                .replace("'", "&#39;");
    }
}
