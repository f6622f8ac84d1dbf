package tompkins.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonControl;
import tompkins.lesson.LessonNumber;
import tompkins.lesson.WithShutter;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.shutter.Shutter;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;

/**
 * A studio with a lesson that fits it.
 *
 * @param studio the studio
 * @param lesson its lesson
 * @param number the number that the lesson moves
 */
public record LessonStudio(Studio studio, Lesson lesson, StudioNumber number) {

    private static final String CONTROL = "lesson.control";

    /**
     * The studio with its lesson; empty if it has none.
     *
     * @throws InvalidPropertyException if the lesson moves a number that the studio does not have, or moves it to a
     *     value that the studio does not accept; the message names the place in the studio
     */
    public static Optional<LessonStudio> of(Studio studio) {
        if (!(studio.lesson() instanceof Lesson lesson)) {
            return Optional.empty();
        }
        LessonControl control = lesson.control();
        StudioNumber number = Experiment.at(CONTROL + ".number", () -> StudioNumber.at(control.number(), studio));
        Experiment.at(CONTROL + ".from", () -> number.with(studio, control.from()));
        Experiment.at(CONTROL + ".to", () -> number.with(studio, control.to()));
        Experiment.at(CONTROL + ".measuredAt", () -> number.with(studio, control.measuredAt()));
        return Optional.of(new LessonStudio(studio, lesson, number));
    }

    /** A studio with the number of its lesson as in an earlier studio; unchanged if not both have it. */
    public static Studio unmoved(Studio studio, Studio earlier) {
        try {
            return of(studio)
                    .filter(lesson -> lesson.number.isIn(earlier))
                    .map(lesson -> lesson.number.with(studio, lesson.number.in(earlier)))
                    .orElse(studio);
        } catch (InvalidPropertyException lessonDoesNotFit) {
            return studio;
        }
    }

    /** The shutter with which a lesson compares that of its scene; empty if it compares none. */
    public static Optional<Class<? extends Shutter>> otherShutter(Lesson lesson) {
        return parts(lesson.numbers())
                .filter(WithShutter.class::isInstance)
                .<Class<? extends Shutter>>map(
                        part -> ((WithShutter) part).shutter().getClass())
                .findFirst();
    }

    private static Stream<Object> parts(Object whole) {
        return Stream.concat(
                Stream.of(whole), Descriptions.parts(whole).stream().flatMap(LessonStudio::parts));
    }

    /** The studio in which everything is measured. */
    public Studio measured() {
        return number.with(studio, lesson.control().measuredAt());
    }

    /**
     * A picture in which something is measured.
     *
     * @param studio its studio
     * @param caption in what it differs from the others
     */
    public record Picture(Studio studio, String caption) {}

    /**
     * The pictures in which is measured, each once and without that of the question; that of {@link #measured} is the
     * first.
     *
     * @throws InvalidPropertyException if something cannot be measured
     */
    public List<Picture> pictures() {
        Experiment experiment = new Experiment(measured(), lesson.control());
        lesson.numbers().forEach(wanted -> experiment.measure(wanted.measurement(), ""));
        return experiment.pictures().entrySet().stream()
                .filter(picture -> !picture.getKey().equals(studio))
                .map(picture -> new Picture(picture.getKey(), picture.getValue()))
                .toList();
    }

    /**
     * Measures all numbers of the lesson.
     *
     * @throws InvalidPropertyException if one cannot be measured; the message names its place in the studio
     */
    public List<LessonResult> results() {
        Experiment experiment = new Experiment(measured(), lesson.control());
        List<LessonResult> results = new ArrayList<>();
        for (LessonNumber wanted : lesson.numbers()) {
            double measured = experiment.measure(wanted.measurement(), path(results.size()) + ".measurement");
            results.add(new LessonResult(wanted, measured, experiment.sketch()));
        }
        return results;
    }

    /**
     * Checks that the scene begins on the slider, and that every measured number agrees with its formula.
     *
     * @throws InvalidPropertyException if one does not, or cannot be measured; the message names its place in the
     *     studio
     */
    public void requireAgreement() {
        lesson.control().requireReached(number.path().toString(), number.in(studio));
        List<LessonResult> results = results();
        for (int i = 0; i < results.size(); i++) {
            LessonResult result = results.get(i);
            if (!result.agrees()) {
                throw new InvalidPropertyException(
                        path(i) + ".value",
                        "within " + NumberText.of(result.number().tolerance()) + " of what is measured, "
                                + NumberText.plain(result.measured(), 8),
                        result.number().value());
            }
        }
    }

    private static String path(int number) {
        return "lesson.numbers[" + number + "]";
    }
}
