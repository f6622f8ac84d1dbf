package tompkins.measure;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2dc;

/**
 * What was measured.
 *
 * @param facts what is told about it; nothing about a profile without an edge
 * @param profile what a line shows; null unless it is a profile
 * @param lines what was fitted, as lines of the picture from point to point, in pixels
 */
public record Measured(List<Fact> facts, Profile profile, List<List<Vector2dc>> lines) {

    /** Its numbers. */
    public Stream<Quantity> quantities() {
        return facts.stream().filter(Quantity.class::isInstance).map(Quantity.class::cast);
    }
}
