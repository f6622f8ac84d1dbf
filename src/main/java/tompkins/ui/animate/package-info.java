/** Numbers that run from one value to another, in the window and as files. */
package tompkins.ui.animate;
