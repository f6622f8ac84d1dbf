/** The studio as the window holds it, with its history, and the ways to its parts. */
package tompkins.ui.model;
