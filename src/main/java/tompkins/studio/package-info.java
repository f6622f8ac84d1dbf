/** The document: all that a scene file holds and the window edits, as immutable records. */
package tompkins.studio;
