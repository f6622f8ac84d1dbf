/** The picture on the screen: made away from the event thread, shown as it gets better, and read pixel by pixel. */
package tompkins.ui.picture;
