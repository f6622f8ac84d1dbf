package tompkins.measure;

import java.util.List;
import org.joml.Vector2dc;

/**
 * What was measured.
 *
 * @param kind what it is
 * @param shape what kind of conic was fitted; null if none was
 * @param quantities its numbers; none of a profile without an edge
 * @param profile what a line shows; null unless it is a profile
 * @param lines what was fitted, as lines of the picture from point to point, in pixels
 */
public record Measured(
        MeasureKind kind,
        ConicFit.Kind shape,
        List<Quantity> quantities,
        Profile profile,
        List<List<Vector2dc>> lines) {

    /** What was measured without a conic. */
    Measured(MeasureKind kind, List<Quantity> quantities, Profile profile, List<List<Vector2dc>> lines) {
        this(kind, null, quantities, profile, lines);
    }
}
