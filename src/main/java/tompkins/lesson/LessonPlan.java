package tompkins.lesson;

/** Whether a scene teaches something: a lesson, or none. */
public sealed interface LessonPlan permits NoLesson, Lesson {}
