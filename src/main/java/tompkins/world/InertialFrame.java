package tompkins.world;

import java.util.List;
import tompkins.primitive.Primitive;
import tompkins.search.ObjectTree;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.surface.Refractive;

/**
 * An inertial frame of the scene, and what rests in it: all objects with one velocity, wherever they are.
 *
 * @param motion how it moves; null if it is the scene frame
 * @param origin the event at which the coordinates of the primitives begin
 * @param objects the primitives
 * @param refractive those that bound a medium
 */
public record InertialFrame(FrameMotion motion, Event origin, ObjectTree objects, List<Primitive> refractive) {

    InertialFrame(FrameMotion motion, Event origin, ObjectTree objects) {
        this(
                motion,
                origin,
                objects,
                objects.primitives().stream()
                        .filter(primitive -> primitive.surface() instanceof Refractive)
                        .toList());
    }
}
