package tompkins.studio;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
import tompkins.property.Require;

/** A part of a ride with the camera: the view changes first, then there is constant thrust for a while, or none. */
@Meaning("A part of a ride: the view changes first, then there is constant thrust for a while, or none")
public record RideLeg(
        @Meaning(value = "How long it lasts in a film, above 0 to 600", unit = "seconds")
        double seconds,

        @Meaning(value = "How long it lasts by a clock on board", unit = "time")
        double properTime,

        @Meaning(
                value = "What an accelerometer on board shows, to the right, up and forwards in the picture",
                unit = "1/length")
        Vector3dc acceleration,

        @Meaning(value = "Turn to the right before it, about the camera's top direction", unit = "degrees")
        double turnRightDegrees,

        @Meaning(value = "Turn up before it", unit = "degrees")
        double turnUpDegrees,

        @Meaning("Factor by which the field of view changes before it")
        double zoom) {

    /** A second without thrust. */
    public static final RideLeg DEFAULT = new RideLeg(1, 1, new Vector3d(), 0, 0, 1);

    /** The most seconds that a leg lasts in a film. */
    public static final double LONGEST = 600;

    /** How much two legs may differ and still count as one. */
    private static final double ROUNDING = 1e-9;

    /** The largest rapidity that thrust gives in one leg. */
    private static final double LARGEST_RAPIDITY = 40;

    /** Checks all values. */
    public RideLeg {
        Require.positive("seconds", seconds, LONGEST);
        Require.distance("properTime", properTime);
        acceleration = Require.finite("acceleration", acceleration);
        double rapidity = acceleration.length() * properTime;
        if (!(rapidity <= LARGEST_RAPIDITY)) {
            throw new InvalidPropertyException(
                    "acceleration",
                    "small enough for a rapidity of at most " + NumberText.of(LARGEST_RAPIDITY) + " in a leg",
                    "a rapidity of " + NumberText.of(rapidity));
        }
        Require.finite("turnRightDegrees", turnRightDegrees);
        Require.within("turnUpDegrees", turnUpDegrees, -180, 180);
        Require.positive("zoom", zoom);
    }

    /** Whether another leg continues this one: with the same view, thrust and pace, except for rounding. */
    boolean goesOn(RideLeg next) {
        double pace = properTime / seconds;
        return next.turnRightDegrees == 0
                && next.turnUpDegrees == 0
                && next.zoom == 1
                && seconds + next.seconds <= LONGEST
                && Math.abs(next.properTime / next.seconds - pace) <= ROUNDING * pace
                && next.acceleration.distance(acceleration) <= ROUNDING * acceleration.length();
    }

    /** This leg together with one that continues it. */
    RideLeg with(RideLeg next) {
        return new RideLeg(
                seconds + next.seconds,
                properTime + next.properTime,
                acceleration,
                turnRightDegrees,
                turnUpDegrees,
                zoom);
    }
}
