/** Steering the camera: by the mouse, by keys, and on a ride. */
package tompkins.ui.ride;
