/**
 * Descriptions of lessons, as a scene file holds them: question, predictions, the number to move, the explanation, and
 * what is measured at the end.
 */
package tompkins.lesson;
