/**
 * The document: all that a scene file holds and the window edits, as immutable records; the ways to its parts, and
 * changes that keep parts in step.
 */
package tompkins.studio;
