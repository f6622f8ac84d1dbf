package tompkins.ui.lesson;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import tompkins.studio.Studio;
import tompkins.ui.model.Settings;
import tompkins.ui.widget.Texts;

/** The lessons of the program in their order, and which of them somebody has finished. */
public final class LessonCourse {

    /** The setting with the titles of finished lessons. */
    private static final String FINISHED = "lessons.finished";

    private static final String SEPARATOR = "|";

    private final Settings settings;
    private final Consumer<Studio> opener;
    private List<Studio> lessons = List.of();
    private Runnable follower = () -> {};

    /** A course without lessons; {@code opener} opens one of them. */
    public LessonCourse(Settings settings, Consumer<Studio> opener) {
        this.settings = settings;
        this.opener = opener;
    }

    /** Puts the lessons in, and tells who follows. */
    public void setLessons(List<Studio> all) {
        lessons = List.copyOf(all);
        follower.run();
    }

    /** All lessons, in their order. */
    public List<Studio> lessons() {
        return lessons;
    }

    /** Calls somebody when the lessons are there; a window opens before that. */
    void follow(Runnable other) {
        follower = other;
    }

    private List<String> finished() {
        return List.of(settings.text(FINISHED, "").split("\\" + SEPARATOR));
    }

    /** Whether a lesson was finished once. */
    public boolean isFinished(Studio lesson) {
        return finished().contains(lesson.title());
    }

    /** Remembers that a lesson of the course was finished. */
    void finish(Studio lesson) {
        if (place(lesson) >= 0 && !isFinished(lesson)) {
            List<String> titles = new ArrayList<>(finished());
            titles.add(lesson.title());
            settings.setText(FINISHED, String.join(SEPARATOR, titles));
        }
    }

    /** The number of a lesson, from 0; -1 if it is not of the course. */
    private int place(Studio lesson) {
        return IntStream.range(0, lessons.size())
                .filter(i -> lessons.get(i).title().equals(lesson.title()))
                .findFirst()
                .orElse(-1);
    }

    /** Which lesson it is, and how many are finished; empty if it is not of the course. */
    String progress(Studio lesson) {
        long done = lessons.stream().filter(this::isFinished).count();
        return place(lesson) < 0 ? "" : Texts.get("lesson.progress", place(lesson) + 1, lessons.size(), done);
    }

    /** The lesson that follows, if there is one. */
    Optional<Studio> after(Studio lesson) {
        int place = place(lesson);
        return place < 0 || place + 1 == lessons.size() ? Optional.empty() : Optional.of(lessons.get(place + 1));
    }

    /** Opens the lesson that follows. */
    void openAfter(Studio lesson) {
        after(lesson).ifPresent(opener);
    }
}
