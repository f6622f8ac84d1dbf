/** Cameras: which ray belongs to a point of the picture and a point of the lens, all in the camera frame. */
package tompkins.camera;
