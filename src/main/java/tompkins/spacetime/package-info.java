/**
 * Velocities and changes of frame.
 *
 * <p>Two frames appear in the program. The <em>camera frame</em> is at rest with the camera; lenses, shutters and
 * windows live there. The <em>scene frame</em> is at rest with the scene. The camera moves through the scene frame with
 * velocity beta; the origins of both frames coincide at time 0 of both. Axes are left-handed: x to the right, y up, z
 * into the picture. c = 1.
 *
 * <p>A transformation is named after its ends, read from right to left: {@code sceneFromCamera} takes camera-frame
 * coordinates and gives those of the scene frame.
 */
package tompkins.spacetime;
