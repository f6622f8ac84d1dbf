package tompkins.sceneobject;

import java.util.ArrayList;
import java.util.List;
import tompkins.primitive.Primitive;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.Velocity;

/** What rests in one inertial frame: all objects with one velocity, wherever they are. */
public final class FrameObjects {

    private final FrameMotion motion;
    private final Event origin;
    private final List<FrameObjects> inner = new ArrayList<>();
    private final List<Primitive> primitives = new ArrayList<>();

    FrameObjects(FrameMotion motion, Event origin) {
        this.motion = motion;
        this.origin = origin;
    }

    /** How the frame moves; null if it is the outermost. */
    public FrameMotion motion() {
        return motion;
    }

    /** The event at which the coordinates of the primitives begin. */
    public Event origin() {
        return origin;
    }

    /** The primitives so far. */
    public List<Primitive> primitives() {
        return List.copyOf(primitives);
    }

    List<Primitive> growing() {
        return primitives;
    }

    /** What moves in this frame with a velocity, or null if nothing does yet. */
    FrameObjects moving(Velocity velocity) {
        for (FrameObjects frame : inner) {
            if (frame.motion.velocity().proper().equals(velocity.proper())) {
                return frame;
            }
        }
        return null;
    }

    void add(FrameObjects frame) {
        inner.add(frame);
    }
}
