/** The studio as the window holds it, with its history, the ways to its parts, and changes that keep parts in step. */
package tompkins.ui.model;
