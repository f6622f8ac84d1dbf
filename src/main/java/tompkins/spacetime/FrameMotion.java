package tompkins.spacetime;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;

/**
 * How an inertial frame moves in the frame that contains it. Its axes are those of a pure boost, and its origin passes
 * the start with own time 0.
 *
 * @param outer the motion of the frame that contains it, or null if that is the scene frame
 * @param velocity velocity in the outer frame
 * @param start an event in the outer frame: place and time of the origin at own time 0
 */
public record FrameMotion(FrameMotion outer, Velocity velocity, Event start) {

    /**
     * Checks how fast the frame is in the scene.
     *
     * @throws InvalidPropertyException if its motion and that of the frame around it are faster together than
     *     {@link Velocity#LARGEST_GAMMA}; it names both
     */
    public void requireGamma(String property) {
        double gamma = gamma();
        if (outer != null && !(gamma <= Velocity.LARGEST_GAMMA)) {
            throw new InvalidPropertyException(
                    property,
                    "such that all motions together stay below gamma " + NumberText.of(Velocity.LARGEST_GAMMA),
                    "gamma " + NumberText.of(NumberText.rounded(velocity.gamma(), 4)) + " in a frame of gamma "
                            + NumberText.of(NumberText.rounded(outer.gamma(), 4)) + ", together "
                            + NumberText.of(NumberText.rounded(gamma, 4)));
        }
    }

    /** The Lorentz factor in the scene frame: gamma12 = gamma1 gamma2 + u1.u2. */
    public double gamma() {
        return outer == null ? velocity.gamma() : gamma(outer, velocity);
    }

    private static double gamma(FrameMotion outer, Velocity inner) {
        return outer.gamma() * inner.gamma() + outer.proper().dot(inner.proper());
    }

    /** The proper velocity in the scene frame: u12 = u2 + u1 ((u1.u2)/(gamma1 + 1) + gamma2). */
    public Vector3dc proper() {
        if (outer == null) {
            return velocity.proper();
        }
        Vector3dc first = outer.proper();
        Vector3dc second = velocity.proper();
        return new Vector3d(second).fma(first.dot(second) / (outer.gamma() + 1) + velocity.gamma(), first);
    }

    /** How place and time in the scene frame change in one unit of the proper time of what rests in this frame. */
    public Event worldLine(TransformationLaw law) {
        return step(law, new Event(0, 0, 0, 1));
    }

    private Event step(TransformationLaw law, Event own) {
        Event moved = law.sceneFromCamera(velocity).transform(own);
        return outer == null ? moved : outer.step(law, moved);
    }

    /** An event of this frame, in the scene frame. */
    public Event inScene(TransformationLaw law, Event own) {
        Event moved = law.sceneFromCamera(velocity).transform(own);
        Event around = new Event(
                moved.x() + start.x(), moved.y() + start.y(), moved.z() + start.z(), moved.time() + start.time());
        return outer == null ? around : outer.inScene(law, around);
    }

    /** Where a point that rests in this frame is at a time of the scene, in the scene frame. */
    public Vector3d placeInScene(TransformationLaw law, Vector3dc own, double sceneTime) {
        Event first = inScene(law, new Event(own.x(), own.y(), own.z(), 0));
        Event later = inScene(law, new Event(own.x(), own.y(), own.z(), 1));
        double time = (sceneTime - first.time()) / (later.time() - first.time());
        Vector3d way = later.position().sub(first.position());
        return first.position().fma(time, way);
    }
}
