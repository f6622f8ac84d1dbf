/** The studio as the window holds it, with its history. */
package tompkins.ui.model;
