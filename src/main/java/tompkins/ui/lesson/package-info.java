/** Lessons: question, looking, reason, numbers. */
package tompkins.ui.lesson;
