/** What is drawn over the picture to explain it. */
package tompkins.ui.overlay;
