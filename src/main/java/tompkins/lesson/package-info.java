/** Descriptions of lessons, as a scene file holds them. */
package tompkins.lesson;
