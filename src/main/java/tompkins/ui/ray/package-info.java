/** The ray of one pixel: read under the pointer, told in words and drawn in space and time. */
package tompkins.ui.ray;
