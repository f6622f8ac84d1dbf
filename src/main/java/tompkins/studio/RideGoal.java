package tompkins.studio;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.spacetime.Velocity;

/** A part of a challenge: to be at a place, with a speed and with clocks in given ranges. */
@Meaning("A part of a challenge: to be at a place, with a speed and with clocks in given ranges")
public record RideGoal(
        @Meaning(value = "The place, in the scene frame", unit = "length")
        Vector3dc position,

        @Meaning(value = "How near to it the lens has to come", unit = "length")
        double within,

        @Meaning("The least Lorentz factor there, 1 for any speed")
        double leastGamma,

        @Meaning("The largest Lorentz factor there; 1.001 is nearly at rest")
        double mostGamma,

        @Meaning(value = "The latest time there, by the clock on board since the start", unit = "time")
        double latest,

        @Meaning(value = "By how much less time at least has passed on board than in the scene", unit = "time")
        double younger) {

    private static final double ANY_TIME = 1e9;

    /** To be at the origin, at any speed and time. */
    public static final RideGoal DEFAULT = new RideGoal(new Vector3d(), 1, 1, Velocity.LARGEST_GAMMA, ANY_TIME, 0);

    /** Checks all values. */
    public RideGoal {
        position = Require.position("position", position);
        Require.distance("within", within);
        Require.within("leastGamma", leastGamma, 1, Velocity.LARGEST_GAMMA);
        Require.within("mostGamma", mostGamma, 1, Velocity.LARGEST_GAMMA);
        if (mostGamma < leastGamma) {
            throw new InvalidPropertyException("mostGamma", "at least leastGamma", mostGamma);
        }
        Require.distance("latest", latest);
        Require.duration("younger", younger);
    }

    /** Whether a step reaches it: its straight way comes near enough, with the speed and clocks of its end. */
    boolean isReached(RideMoment before, RideMoment now) {
        double gamma = now.rider().gamma();
        return gamma >= leastGamma
                && gamma <= mostGamma
                && now.properTime() <= latest
                && now.sceneTime() - now.properTime() >= younger
                && distance(
                                before.rider().event().position(),
                                now.rider().event().position())
                        <= within;
    }

    private double distance(Vector3d from, Vector3d to) {
        Vector3d way = to.sub(from, new Vector3d());
        Vector3d aside = position.sub(from, new Vector3d());
        double part = way.lengthSquared() == 0 ? 0 : aside.dot(way) / way.lengthSquared();
        return Vectors.length(aside.fma(-Math.max(0, Math.min(1, part)), way));
    }
}
