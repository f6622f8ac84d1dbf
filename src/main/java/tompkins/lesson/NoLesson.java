package tompkins.lesson;

import tompkins.property.Meaning;

/** The scene is a picture without a lesson. */
@Meaning("No lesson: the scene is a picture and nothing else")
public record NoLesson() implements LessonPlan {

    /** The only one. */
    public static final NoLesson DEFAULT = new NoLesson();
}
