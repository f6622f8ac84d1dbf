package tompkins.measure;

import java.util.List;
import org.joml.Vector2dc;

/**
 * What was measured.
 *
 * @param kind what it is
 * @param quantities its numbers; none of a profile without an edge
 * @param profile what a line shows; null unless it is a profile
 * @param lines what was fitted, as lines of the picture from point to point, in pixels
 */
public record Measured(MeasureKind kind, List<Quantity> quantities, Profile profile, List<List<Vector2dc>> lines) {}
