package tompkins.ui.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.JList;
import javax.swing.JScrollPane;
import tompkins.io.LessonSheet;
import tompkins.lesson.Lesson;
import tompkins.measure.LessonStudio;
import tompkins.render.PhotographTaker;
import tompkins.render.Progress;
import tompkins.studio.Studio;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Texts;

/** Saves sheets of lessons, to be printed, with the answers in a second file. */
public final class SheetExport {

    private final WindowParts window;
    private final FileDialogs dialogs;

    /** Saves sheets for a window. */
    public SheetExport(WindowParts window, FileDialogs dialogs) {
        this.window = window;
        this.dialogs = dialogs;
    }

    /**
     * Asks which lessons a sheet should have, and where to save it. The lesson of the window is chosen at first.
     *
     * @param course the lessons of the program
     */
    public void ask(List<Studio> course) {
        Studio opened = window.model().opened();
        boolean isOfCourse = course.stream().anyMatch(each -> each.title().equals(opened.title()));
        List<Studio> lessons = Stream.concat(
                        isOfCourse || !(opened.lesson() instanceof Lesson) ? Stream.empty() : Stream.of(opened),
                        course.stream())
                .toList();
        JList<String> list = new JList<>(lessons.stream().map(Studio::title).toArray(String[]::new));
        Naming.name(list, Texts.get("sheet.lessons"), Texts.get("sheet.lessonsTip"));
        list.setSelectedValue(opened.title(), true);
        JFileChooser chooser = dialogs.chooser();
        chooser.setAccessory(new JScrollPane(list));
        SaveDialog.ask(
                window.frame(),
                chooser,
                Texts.get("sheet.title"),
                dialogs.fileName(),
                List.of(new FormatFilter<>("html", Texts.get("sheet.format"), List.of(".html", ".htm"))),
                (file, format, replace) -> save(chosen(lessons, list.getSelectedIndices()), file, replace));
    }

    /** The chosen lessons; all if none is. */
    private static List<Studio> chosen(List<Studio> lessons, int... places) {
        return places.length == 0
                ? lessons
                : Arrays.stream(places).mapToObj(lessons::get).toList();
    }

    private void save(List<Studio> lessons, Path file, boolean replace) {
        dialogs.save(
                file,
                task -> LessonSheet.save(sheets(lessons, task), file, replace),
                files -> dialogs.exported(files.get(0), List.of(Texts.get("sheet.answers", files.get(1)))));
    }

    private static List<LessonSheet> sheets(List<Studio> lessons, Progress progress)
            throws IOException, InterruptedException {
        List<LessonSheet> sheets = new ArrayList<>();
        try (PhotographTaker taker = new PhotographTaker()) {
            for (Studio studio : lessons) {
                LessonStudio lesson = LessonStudio.of(studio).orElseThrow();
                sheets.add(LessonSheet.of(lesson, lesson.results(), taker, progress));
            }
        }
        return sheets;
    }
}
