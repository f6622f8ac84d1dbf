package tompkins.fuzz;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import tompkins.lesson.AngleBetween;
import tompkins.lesson.CircleRadius;
import tompkins.lesson.DifferenceOf;
import tompkins.lesson.LensSpread;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonControl;
import tompkins.lesson.LessonNumber;
import tompkins.lesson.LessonPlan;
import tompkins.lesson.Measurement;
import tompkins.lesson.MeasuringPoint;
import tompkins.lesson.NoLesson;
import tompkins.lesson.OnRide;
import tompkins.lesson.PictureEdge;
import tompkins.lesson.PicturePoint;
import tompkins.lesson.Prediction;
import tompkins.lesson.RatioOf;
import tompkins.lesson.RayReading;
import tompkins.lesson.RayValue;
import tompkins.lesson.StarCount;
import tompkins.lesson.WithNumber;
import tompkins.lesson.WithShutter;
import tompkins.shutter.AperturePlaneShutter;

/** Valid lessons with all kinds of measurements. The same seed gives the same one. */
final class RandomLesson {

    private static final int DEEPEST = 2;

    private final SplittableRandom random;

    private RandomLesson(long seed) {
        random = new SplittableRandom(seed);
    }

    /** The lesson with a number; three times of four, none. */
    static LessonPlan of(long seed) {
        RandomLesson maker = new RandomLesson(seed);
        return maker.random.nextInt(4) == 0 ? maker.lesson() : NoLesson.DEFAULT;
    }

    private Lesson lesson() {
        return new Lesson(
                "What is seen?",
                List.of(new Prediction("All", ""), new Prediction("Nothing", "Look again.")),
                1 + random.nextInt(2),
                new LessonControl("velocity.beta", "Speed", -1, random.nextDouble(), -0.5),
                "So it is.",
                random.nextBoolean() ? "" : "Much is seen.",
                random.nextBoolean() ? "" : "x: how much.",
                Stream.generate(this::number).limit(random.nextInt(5)).toList());
    }

    private LessonNumber number() {
        return new LessonNumber("number", measurement(DEEPEST), "x", random.nextDouble(), 0.01, "");
    }

    @SafeVarargs
    private <T> T pick(T... choices) {
        return choices[random.nextInt(choices.length)];
    }

    private Measurement measurement(int depth) {
        Class<?>[] types = Measurement.class.getPermittedSubclasses();
        String name = depth == 0 ? "RayReading" : types[random.nextInt(types.length)].getSimpleName();
        return switch (name) {
            case "RayReading" -> new RayReading(point(), pick(RayValue.values()));
            case "AngleBetween" -> new AngleBetween(point(), point());
            case "CircleRadius" -> new CircleRadius(random.nextDouble(), random.nextDouble());
            case "LensSpread" -> new LensSpread(random.nextDouble(), random.nextDouble());
            case "StarCount" -> new StarCount(180 * random.nextDouble());
            case "DifferenceOf" -> new DifferenceOf(measurement(depth - 1), measurement(depth - 1));
            case "RatioOf" -> new RatioOf(measurement(depth - 1), measurement(depth - 1));
            case "WithNumber" -> new WithNumber("velocity.beta", random.nextDouble(), measurement(depth - 1));
            case "WithShutter" ->
                new WithShutter(new AperturePlaneShutter(random.nextDouble()), measurement(depth - 1));
            case "OnRide" -> new OnRide(random.nextDouble(), measurement(depth - 1));
            default -> throw new IllegalStateException("no random " + name + " yet");
        };
    }

    private MeasuringPoint point() {
        return random.nextBoolean()
                ? new PicturePoint(random.nextDouble(), random.nextDouble())
                : new PictureEdge(random.nextDouble(), random.nextDouble(), 0, 1, 1 + random.nextInt(3));
    }
}
