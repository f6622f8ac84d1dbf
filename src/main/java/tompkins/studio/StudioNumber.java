package tompkins.studio;

import java.util.List;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.SpeedScale;

/**
 * A decimal number of a studio, by its place.
 *
 * @param place the way to it
 */
public record StudioNumber(StudioPath place) {

    private static final StudioPath VELOCITY = StudioPath.ROOT.then("velocity");

    /** The time at which the shutter opens; some shutters have none. */
    public static final StudioNumber OPENING_TIME =
            new StudioNumber(StudioPath.ROOT.then("camera").then("shutter").then("openingTime"));

    private static final String EXAMPLES = "such as velocity.beta, camera.shutter.openingTime or scene[0].radius";

    /** The speed of the camera on a scale; its direction stays. */
    public static StudioNumber speed(SpeedScale scale) {
        return new StudioNumber(VELOCITY.then(scale.key()));
    }

    /**
     * The number at a place that is written as messages do, such as {@code scene[0].centre.x}.
     *
     * @throws InvalidPropertyException if the studio has no decimal number there
     */
    public static StudioNumber at(String place, Studio studio) {
        StudioPath path = StudioPath.parse(place)
                .orElseThrow(() -> new InvalidPropertyException("place", "that of a number, " + EXAMPLES, place));
        StudioNumber number = new StudioNumber(path);
        if (number.isIn(studio)) {
            return number;
        }
        StudioPath known = new StudioPath(path.steps().subList(0, path.length(studio)));
        Object part = known.get(studio);
        List<String> further = StudioPath.stepsFrom(part);
        if (!further.isEmpty()) {
            String start = known.equals(StudioPath.ROOT) ? "that begins" : "that goes on after " + known;
            throw new InvalidPropertyException("place", "one " + start + " with " + String.join(", ", further), place);
        }
        String leaf = known + " is not a number that can change step by step";
        throw new InvalidPropertyException("place", "that of a number, " + EXAMPLES + " (" + leaf + ")", place);
    }

    /** Whether this is the speed of the camera, on any scale. */
    public boolean isSpeed() {
        return place.parent().equals(VELOCITY);
    }

    /** Whether a studio has a decimal number there. */
    public boolean isIn(Studio studio) {
        return place.length(studio) == place.steps().size() && place.get(studio) instanceof Double;
    }

    /** Its value in a studio that has it. */
    public double in(Studio studio) {
        return (Double) place.get(studio);
    }

    /**
     * The studio with another value; a window in front of the lens that has the velocity of the camera keeps it.
     *
     * @throws InvalidPropertyException if the studio does not accept the value
     */
    public Studio with(Studio studio, double value) {
        return FrontWindow.following(studio, place.with(studio, value));
    }
}
