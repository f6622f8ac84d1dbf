package tompkins.sceneobject;

import java.util.List;
import tompkins.primitive.Primitive;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;

/**
 * What rests in one inertial frame: all objects with one velocity, wherever they are.
 *
 * @param motion how the frame moves; null if it is the outermost
 * @param origin the event at which the coordinates of the primitives begin
 * @param primitives the primitives so far; the list grows
 */
public record FrameObjects(FrameMotion motion, Event origin, List<Primitive> primitives) {}
