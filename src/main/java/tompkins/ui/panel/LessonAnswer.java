package tompkins.ui.panel;

import tompkins.lesson.Prediction;

/**
 * What a reader answered before looking.
 *
 * @param prediction what is expected
 * @param sure whether the answer is sure
 */
record LessonAnswer(Prediction prediction, boolean sure) {}
