package tompkins.world;

import tompkins.search.ObjectTree;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;

/**
 * An inertial frame of the scene, and what rests in it: all objects with one velocity, wherever they are.
 *
 * @param motion how it moves; null if it is the scene frame
 * @param origin the event at which the coordinates of the primitives begin
 * @param objects the primitives
 */
public record InertialFrame(FrameMotion motion, Event origin, ObjectTree objects) {}
