/**
 * Velocities, inertial frames, and the ways between them.
 *
 * <p>The <em>scene frame</em> is at rest with the scene. In it move the <em>camera frame</em>, in which lenses,
 * shutters and windows live, and the frames of what moves in the scene; each may hold further ones. The camera moves
 * through the scene frame with velocity beta; the origins of both frames coincide at time 0 of both. Axes are
 * left-handed: x to the right, y up, z into the picture. c = 1.
 *
 * <p>{@link tompkins.spacetime.FrameTree} is the home of frames: it gives the way between any two of them, along which
 * events, differences, rays and world lines are taken. A transformation is named after its ends, read from right to
 * left: {@code sceneFromCamera} takes camera-frame coordinates and gives those of the scene frame.
 */
package tompkins.spacetime;
