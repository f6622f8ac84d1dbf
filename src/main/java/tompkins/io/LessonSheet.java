package tompkins.io;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import tompkins.file.FileException;
import tompkins.file.PendingFile;
import tompkins.image.LinearImage;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFormat;
import tompkins.image.ToneCurve;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonControl;
import tompkins.lesson.Prediction;
import tompkins.measure.LessonResult;
import tompkins.measure.LessonStudio;
import tompkins.property.NumberText;
import tompkins.property.OneLine;
import tompkins.render.PhotographTaker;
import tompkins.render.Progress;
import tompkins.studio.Studio;

/**
 * A lesson to be printed: question and pictures, and room to write. Several make one page for a class, and the answers
 * make another. A page is one file that loads nothing from elsewhere; all texts of the lesson are letters in it and
 * never tags.
 *
 * @param lesson the lesson with its scene
 * @param question the picture that is seen with the question, in PNG
 * @param measured the pictures in which is measured
 * @param results what the program measures
 */
public record LessonSheet(LessonStudio lesson, byte[] question, List<Shown> measured, List<LessonResult> results) {

    private static final String STYLE = """
            @page { margin: 2cm }
            body { font: 11pt/1.45 serif; max-width: 17cm; margin: auto }
            section { break-after: page }
            section:last-child { break-after: auto }
            figure { display: inline-block; margin: 0.3cm 0; max-width: 100%; break-inside: avoid }
            figure.part { width: 49% }
            img { display: block; max-width: 100%; max-height: 10cm }
            figcaption { font-size: 9pt }
            .line { border-bottom: 1px solid #888; height: 0.9cm }
            table { border-collapse: collapse; width: 100% }
            th, td { border: 1px solid #888; padding: 0.15cm 0.25cm; text-align: left; vertical-align: top }
            """;

    private static final int LINES = 4;

    /**
     * A picture.
     *
     * @param caption what is written below it
     * @param png the picture
     */
    public record Shown(String caption, byte[] png) {}

    /**
     * Takes the pictures of a lesson.
     *
     * @param results what was measured, so that it is known that it can be
     */
    public static LessonSheet of(
            LessonStudio lesson, List<LessonResult> results, PhotographTaker taker, Progress progress)
            throws IOException, InterruptedException {
        byte[] question = png(lesson.studio(), taker, progress);
        List<Shown> measured = new ArrayList<>();
        for (LessonStudio.Picture picture : lesson.pictures()) {
            measured.add(new Shown(picture.caption(), png(picture.studio(), taker, progress)));
        }
        return new LessonSheet(lesson, question, measured, results);
    }

    /** The picture alone: the scene in it would hold the answers. */
    private static byte[] png(Studio studio, PhotographTaker taker, Progress progress)
            throws IOException, InterruptedException {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        LinearImage image = taker.take(studio, progress, 0, 1).image();
        ToneCurve curve = studio.settings().toneCurve();
        PhotographFile.encode(png, image, PictureFormat.PNG, curve, PhotographInfo.NONE);
        return png.toByteArray();
    }

    /** The file beside a sheet that has the answers to its questions. */
    public static Path answersOf(Path sheet) {
        return sheet.resolveSibling(sheet.getFileName().toString().replaceFirst("(\\.[^.]*)?$", "-answers$1"));
    }

    /**
     * Writes a page with lessons, and one with the answers.
     *
     * @param replace whether files of these names are replaced; otherwise those that are written get numbers
     * @return both files, that with the answers last
     */
    public static List<Path> save(List<LessonSheet> sheets, Path file, boolean replace) throws FileException {
        String title = sheets.stream()
                .map(sheet -> sheet.lesson.studio())
                .map(sheets.size() == 1 ? Studio::title : Studio::shortTitle)
                .collect(Collectors.joining(", "));
        String questions = sheets.stream()
                .map(sheet -> section(sheet.asking()) + section(sheet.measuring()))
                .collect(Collectors.joining());
        String answers = sheets.stream().map(sheet -> section(sheet.answers())).collect(Collectors.joining());
        Path first = save(page(title, questions), file, replace);
        return List.of(first, save(page("Answers: " + title, answers), answersOf(first), replace));
    }

    private static Path save(String page, Path file, boolean replace) throws FileException {
        return PendingFile.save(file, replace, out -> out.write(page.getBytes(StandardCharsets.UTF_8)));
    }

    private static String page(String title, String sections) {
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
                %s</body>
                </html>
                """, text(title), STYLE, sections);
    }

    private Lesson content() {
        return lesson.lesson();
    }

    private String asking() {
        LessonControl control = content().control();
        String caption = control.name() + ": " + NumberText.of(lesson.number().in(lesson.studio()));
        return tag("h1", text(lesson.studio().title()))
                + tag("p", text(content().question()))
                + figure(new Shown(caption, question), "whole")
                + tag("p", text(FactText.readable(lesson.studio().remarks())))
                + content().shuffled().stream()
                        .map(prediction -> tag("p", "&#x2610; " + text(prediction.text())))
                        .collect(Collectors.joining())
                + tag("p", "I am &#x2610; sure, &#x2610; not sure, because")
                + lines(LINES);
    }

    private String measuring() {
        String size = measured.size() == 1 ? "whole" : "part";
        return tag("h2", "Look, and measure: " + text(lesson.studio().shortTitle()))
                + measured.stream().map(picture -> figure(picture, size)).collect(Collectors.joining())
                + tag("p", "What do you see? Why is it so?")
                + lines(LINES)
                + tag("p", "Work the numbers out, and measure as many as you can in the pictures.")
                + tag("p", text(FactText.readable(content().letters())))
                + table(
                        "<th>number<th>worked out<th>measured",
                        results.stream()
                                .map(result -> "<td>" + text(result.number().name()) + unit(result) + "<td><td>")
                                .toList());
    }

    private String answers() {
        return tag("h2", "Answers: " + text(lesson.studio().title()))
                + content().shuffled().stream().map(this::answer).collect(Collectors.joining())
                + tag("p", text(FactText.readable(content().reveal())))
                + tag("p", text(FactText.readable(content().law())))
                + tag("p", text(FactText.readable(content().letters())))
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
        String sign = content().isRight(prediction) ? "&#x2611; " : "&#x2610; ";
        return tag("p", sign + tag("b", text(prediction.text())).strip() + " " + text(prediction.reply()));
    }

    private static String unit(LessonResult result) {
        String unit = result.number().unit();
        return unit.isEmpty() ? "" : " (" + text(unit) + ")";
    }

    private static String section(String content) {
        return tag("section", "\n" + content);
    }

    private static String figure(Shown shown, String size) {
        String caption = text(shown.caption);
        return "<figure class=\"" + size + "\"><img alt=\"" + caption + "\" src=\"data:image/png;base64,"
                + Base64.getEncoder().encodeToString(shown.png) + "\">"
                + tag("figcaption", caption).strip() + "</figure>\n";
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
