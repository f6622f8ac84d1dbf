package tompkins.spacetime;

import java.util.ArrayList;
import java.util.List;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;

/**
 * How an inertial frame moves in the frame that contains it. Its axes are those of a pure boost, and its origin passes
 * the start with proper time 0. The scene frame, which contains all others, has no motion: it is null. The camera frame
 * moves in the scene frame like any other. {@link FrameTree} has the ways between frames.
 *
 * @param outer the motion of the frame that contains it, or null if that is the scene frame
 * @param velocity velocity in the outer frame
 * @param start an event in the outer frame: place and time of the origin at proper time 0
 */
public record FrameMotion(FrameMotion outer, Velocity velocity, Event start) {

    /** The frames from the outermost to this one, of which the first moves in the scene frame; none for null. */
    static List<FrameMotion> chain(FrameMotion motion) {
        List<FrameMotion> chain = new ArrayList<>();
        for (FrameMotion each = motion; each != null; each = each.outer) {
            chain.add(0, each);
        }
        return chain;
    }

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

    /** The Lorentz factor in the scene frame. */
    public double gamma() {
        ProperVelocity sum = ProperVelocity.of(velocity);
        for (FrameMotion each = outer; each != null; each = each.outer) {
            sum = ProperVelocity.of(each.velocity).plus(sum);
        }
        return sum.gamma();
    }

    /** The way from this frame to the scene frame. */
    public FrameRoute toScene(TransformationLaw law) {
        return FrameTree.described(law).route(this, null);
    }
}
