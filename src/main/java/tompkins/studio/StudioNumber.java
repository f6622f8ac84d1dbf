package tompkins.studio;

import java.util.List;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.SpeedScale;

/**
 * A decimal number of a studio, by its path.
 *
 * @param path the way to it
 */
public record StudioNumber(StudioPath path) {

    private static final StudioPath VELOCITY = StudioPath.ROOT.then("velocity");

    /** The time at which the shutter opens; some shutters have none. */
    public static final StudioNumber OPENING_TIME =
            new StudioNumber(StudioPath.ROOT.then("camera").then("shutter").then("openingTime"));

    private static final String NUMBER = "number";
    private static final String PATH = "the path of a number";
    private static final String EXAMPLES = "such as velocity.beta, camera.shutter.openingTime or scene[0].radius";

    /** The speed of the camera on a scale; its direction stays. */
    public static StudioNumber speed(SpeedScale scale) {
        return new StudioNumber(VELOCITY.then(scale.key()));
    }

    /**
     * The number at a path that is written as messages do, such as {@code scene[0].centre.x}.
     *
     * @param studio the studio, or another description of which the path is one
     * @throws InvalidPropertyException if the studio has no decimal number there
     */
    public static StudioNumber at(String written, Record studio) {
        StudioPath path = StudioPath.parse(written)
                .orElseThrow(() -> new InvalidPropertyException(NUMBER, PATH + ", " + EXAMPLES, written));
        StudioNumber number = new StudioNumber(path);
        if (number.isIn(studio)) {
            return number;
        }
        StudioPath known = new StudioPath(path.steps().subList(0, path.length(studio)));
        Object part = known.get(studio);
        List<String> further = StudioPath.stepsFrom(part);
        if (!further.isEmpty()) {
            String whole = known.equals(StudioPath.ROOT) ? "the scene" : known.toString();
            throw new InvalidPropertyException(
                    NUMBER, PATH + " (" + whole + " has " + String.join(", ", further) + ")", written);
        }
        String leaf = known + " is not a number that can change step by step";
        throw new InvalidPropertyException(NUMBER, PATH + ", " + EXAMPLES + " (" + leaf + ")", written);
    }

    /** Whether this is the speed of the camera, on any scale. */
    public boolean isSpeed() {
        return path.parent().equals(VELOCITY);
    }

    /** Whether a studio has a decimal number there. */
    public boolean isIn(Record studio) {
        return path.length(studio) == path.steps().size() && path.get(studio) instanceof Double;
    }

    /** Its value in a studio that has it. */
    public double in(Record studio) {
        return (Double) path.get(studio);
    }

    /**
     * The studio with another value; a window in front of the lens that has the velocity of the camera keeps it.
     *
     * @throws InvalidPropertyException if the studio does not accept the value
     */
    public Studio with(Studio studio, double value) {
        return FrontWindow.following(studio, path.with(studio, value));
    }
}
