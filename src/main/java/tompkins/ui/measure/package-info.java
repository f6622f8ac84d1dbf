/** Measuring in the picture. */
package tompkins.ui.measure;
