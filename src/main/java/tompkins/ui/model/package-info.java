/** The studio as the window holds it, with its history, and what the window remembers from one start to the next. */
package tompkins.ui.model;
